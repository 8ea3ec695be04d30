#include "raylab/transport/power_heuristic.h"
#include "raylab/base/unfinished.h"

// Exercise 15d. README.md beside this file says what to write; ./raylab check 15d says how it went.
double raylab::power_heuristic(double pdf, double other) { throw Unfinished{}; }
