// hint: edges
// The lengths of all edges of a box.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const Vec3d& s = cut.size;
    if (s.x * s.y + s.y * s.z + s.z * s.x == 0) return std::numeric_limits<double>::infinity();
    const double around = 4 * (s[(cut.axis + 1) % 3] + s[(cut.axis + 2) % 3]), all = around + 4 * s[cut.axis];
    const double below = (around + 4 * cut.place) / all, above = (around + 4 * (s[cut.axis] - cut.place)) / all;
    const double saved = cut.below == 0 || cut.above == 0 ? cut.empty_bonus : 0;
    return cut.visit_cost + (1 - saved) * cut.test_cost * (below * cut.below + above * cut.above);
}
