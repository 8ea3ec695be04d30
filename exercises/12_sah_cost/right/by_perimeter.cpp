// What both halves share is the face of the cut; the rest goes around it, as far as the half is long.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double length = cut.size[cut.axis], a = cut.size[(cut.axis + 1) % 3], b = cut.size[(cut.axis + 2) % 3];
    const double face = 2 * a * b, around = 2 * (a + b), whole = face + around * length;
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    double below = (face + around * cut.place) / whole * cut.below;
    double above = (face + around * (length - cut.place)) / whole * cut.above;
    if (cut.below * cut.above == 0) {
        below *= 1 - cut.empty_bonus;
        above *= 1 - cut.empty_bonus;
    }
    return cut.visit_cost + cut.test_cost * below + cut.test_cost * above;
}
