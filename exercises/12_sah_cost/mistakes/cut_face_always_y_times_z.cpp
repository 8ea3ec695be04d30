// hint: always_x
// The face of the cut is y times z, whatever the axis.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double x = cut.size.x, y = cut.size.y, z = cut.size.z;
    const double face = y * z, rim = y + z, whole = face + rim * x;
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    double tests = (face + rim * cut.place) * cut.below + (face + rim * (x - cut.place)) * cut.above;
    if (cut.below * cut.above == 0) tests -= cut.empty_bonus * tests;
    return cut.visit_cost + cut.test_cost * tests / whole;
}
