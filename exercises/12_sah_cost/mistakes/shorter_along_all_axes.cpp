// hint: one_axis
// Takes the place of the plane off all three sides of the upper half.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto half_surface = [](const Vec3d& s) { return s.x * s.y + s.y * s.z + s.z * s.x; };
    const double all = half_surface(cut.size);
    if (all == 0) return std::numeric_limits<double>::infinity();
    Vec3d below = cut.size;
    below[cut.axis] = cut.place;
    const Vec3d above = cut.size - Vec3d(cut.place);
    const double tests = ((cut.below * half_surface(below) + cut.above * half_surface(above)) / all) * cut.test_cost;
    const bool saves = cut.below == 0 || cut.above == 0;
    return cut.visit_cost + (saves ? tests * (1 - cut.empty_bonus) : tests);
}
