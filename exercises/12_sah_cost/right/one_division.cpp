// One division at the end.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const int b = (cut.axis + 1) % 3, c = (cut.axis + 2) % 3;
    const double face = cut.size[b] * cut.size[c], rim = cut.size[b] + cut.size[c];
    const double whole = face + rim * cut.size[cut.axis];
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    double tests = (face + rim * cut.place) * cut.below + (face + rim * (cut.size[cut.axis] - cut.place)) * cut.above;
    if (cut.below * cut.above == 0) tests -= cut.empty_bonus * tests;
    return cut.visit_cost + cut.test_cost * tests / whole;
}
