// hint: visit_forgotten
// The visit itself is for nothing.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

namespace {

double area(const raylab::Vec3d& s) { return 2 * (s.x * s.y + s.y * s.z + s.z * s.x); }

}  // namespace

double raylab::sah_cost(const SahCut& cut) {
    Vec3d below = cut.size, above = cut.size;
    below[cut.axis] = cut.place;
    above[cut.axis] -= cut.place;
    if (area(cut.size) == 0) return std::numeric_limits<double>::infinity();
    const double tests = (area(below) * cut.below + area(above) * cut.above) / area(cut.size);
    const double bonus = cut.below == 0 || cut.above == 0 ? cut.empty_bonus : 0;
    return cut.test_cost * (1 - bonus) * tests;
}
