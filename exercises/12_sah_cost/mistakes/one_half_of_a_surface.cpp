// hint: halves_of_area
// Half of one half's surface alone.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto area = [](const Vec3d& s) { return s.x * s.y + s.y * s.z + s.z * s.x; };
    const double all = area(cut.size);
    if (all == 0) return std::numeric_limits<double>::infinity();
    Vec3d below = cut.size, above = cut.size;
    below[cut.axis] = cut.place;
    above[cut.axis] -= cut.place;
    const double hits = area(below) / (2 * all) * cut.below + area(above) / all * cut.above;
    const bool is_empty = cut.below == 0 || cut.above == 0;
    return cut.visit_cost + cut.test_cost * hits * (is_empty ? 1 - cut.empty_bonus : 1);
}
