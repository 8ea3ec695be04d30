// hint: edges
// x + y + z for a surface.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const Vec3d& s = cut.size;
    if (s.x * s.y + s.y * s.z + s.z * s.x == 0) return std::numeric_limits<double>::infinity();
    const auto sides = [](const Vec3d& box) { return box.x + box.y + box.z; };
    Vec3d below = s, above = s;
    below[cut.axis] = cut.place;
    above[cut.axis] = s[cut.axis] - cut.place;
    double tests = cut.test_cost * (sides(below) * cut.below + sides(above) * cut.above) / sides(s);
    if (cut.below == 0 || cut.above == 0) tests *= 1 - cut.empty_bonus;
    return cut.visit_cost + tests;
}
