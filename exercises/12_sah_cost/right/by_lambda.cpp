// A lambda for the area.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto area = [](double x, double y, double z) { return x * y + y * z + z * x; };
    const auto half = [&](double length) {
        Vec3d s = cut.size;
        s[cut.axis] = length;
        return area(s.x, s.y, s.z);
    };
    const double all = area(cut.size.x, cut.size.y, cut.size.z);
    if (all == 0) return std::numeric_limits<double>::infinity();
    const double expected = (half(cut.place) * cut.below + half(cut.size[cut.axis] - cut.place) * cut.above) / all;
    const double share = cut.below > 0 && cut.above > 0 ? 1 : 1 - cut.empty_bonus;
    return cut.visit_cost + cut.test_cost * share * expected;
}
