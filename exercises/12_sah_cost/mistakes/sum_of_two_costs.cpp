// hint: visit_twice
// Adds the costs of two halves, and each of them has the visit in it.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double a = cut.size[(cut.axis + 1) % 3], b = cut.size[(cut.axis + 2) % 3], length = cut.size[cut.axis];
    const double whole = a * b + (a + b) * length;
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    const double kept = cut.below * cut.above == 0 ? 1 - cut.empty_bonus : 1;
    const auto cost = [&](double from, double to, double things) {
        const double chance = (a * b + (a + b) * (to - from)) / whole;
        return cut.visit_cost + chance * things * cut.test_cost * kept;
    };
    return cost(0, cut.place, cut.below) + cost(cut.place, length, cut.above);
}
