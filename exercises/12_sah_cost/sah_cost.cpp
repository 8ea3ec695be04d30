#include "raylab/accelerator/split_tree/sah_cost.h"
#include "raylab/base/unfinished.h"

// Exercise 12. README.md beside this file says what to write; ./raylab check 12 says how it went.
double raylab::sah_cost(const SahCut& cut) { throw Unfinished{}; }
