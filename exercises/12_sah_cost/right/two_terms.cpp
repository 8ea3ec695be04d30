// Each half's term by itself.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

namespace {

double area(const raylab::Vec3d& s) { return 2 * (s.x * s.y + s.y * s.z + s.z * s.x); }

}  // namespace

double raylab::sah_cost(const SahCut& cut) {
    raylab::Vec3d l = cut.size, u = cut.size;
    l[cut.axis] = cut.place;
    u[cut.axis] = cut.size[cut.axis] - cut.place;
    const double whole = area(cut.size);
    if (whole == 0) return std::numeric_limits<double>::infinity();
    const double pl = area(l) / whole, pu = area(u) / whole;
    const bool empty = cut.below == 0 || cut.above == 0;

    const double factor = empty ? cut.test_cost * (1 - cut.empty_bonus) : cut.test_cost;
    return cut.visit_cost + factor * pl * cut.below + factor * pu * cut.above;
}
