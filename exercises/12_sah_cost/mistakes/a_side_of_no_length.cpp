// hint: flat_cells
// Gives up where any side of the cell has no length, though two of them are enough for an area.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    for (int side = 0; side < 3; ++side)
        if (cut.size[side] <= 0) return std::numeric_limits<double>::infinity();
    const double face = cut.size[(cut.axis + 1) % 3] * cut.size[(cut.axis + 2) % 3];
    const double rim = cut.size[(cut.axis + 1) % 3] + cut.size[(cut.axis + 2) % 3];
    const auto faces = [&](double length) { return face + rim * length; };
    const double all = faces(cut.size[cut.axis]);
    const double lower = faces(cut.place) / all, upper = faces(cut.size[cut.axis] - cut.place) / all;
    const double saved = cut.below > 0 && cut.above > 0 ? 0 : cut.empty_bonus;
    return cut.visit_cost + (1 - saved) * cut.test_cost * (lower * cut.below + upper * cut.above);
}
