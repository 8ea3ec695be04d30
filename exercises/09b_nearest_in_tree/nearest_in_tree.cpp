#include "raylab/accelerator/bvh/nearest_in_tree.h"

#include "raylab/base/unfinished.h"

// Exercise 09b. README.md beside this file says what to write; ./raylab check 09b says how it went.
std::optional<double> raylab::nearest_in_tree(const AskedTree& tree) { throw Unfinished{}; }
