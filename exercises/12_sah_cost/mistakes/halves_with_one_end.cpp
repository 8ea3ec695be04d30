// hint: cut_face
// The cell has two ends, but each half has one: the cut gives it no other.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double length = cut.size[cut.axis], a = cut.size[(cut.axis + 1) % 3], b = cut.size[(cut.axis + 2) % 3];
    const double end = a * b, around = 2 * (a + b);
    const double whole = 2 * end + around * length;
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    double below = (end + around * cut.place) / whole * cut.below;
    double above = (end + around * (length - cut.place)) / whole * cut.above;
    if (cut.below * cut.above == 0) {
        below *= 1 - cut.empty_bonus;
        above *= 1 - cut.empty_bonus;
    }
    return cut.visit_cost + cut.test_cost * below + cut.test_cost * above;
}
