// hint: half_for_each
// As if all things were tested by every ray.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double x = cut.size[0], y = cut.size[1], z = cut.size[2];
    if (x * y == 0 && y * z == 0 && z * x == 0) return std::numeric_limits<double>::infinity();
    double tests = cut.test_cost * (cut.below + cut.above);
    if (cut.below * cut.above == 0) tests -= cut.empty_bonus * tests;
    return cut.visit_cost + tests;
}
