// hint: rest_of_area
// Divides each half by the sum of both, so that a ray hits exactly one of them.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto half_surface = [](const Vec3d& s) { return s.x * s.y + s.y * s.z + s.z * s.x; };
    const double all = half_surface(cut.size);
    if (all == 0) return std::numeric_limits<double>::infinity();
    Vec3d below = cut.size, above = cut.size;
    below[cut.axis] = cut.place;
    above[cut.axis] -= cut.place;
    const double a = half_surface(below), b = half_surface(above);
    const double tests = ((cut.below * a + cut.above * b) / (a + b)) * cut.test_cost;
    const bool saves = cut.below == 0 || cut.above == 0;
    return cut.visit_cost + (saves ? tests * (1 - cut.empty_bonus) : tests);
}
