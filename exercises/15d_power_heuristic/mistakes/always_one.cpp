// hint: always_one
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) { return 1; }
