// hint: bonus_when
// A case for each empty half, and the bonus only in the second one.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto surface = [&](double length) {
        Vec3d box = cut.size;
        box[cut.axis] = length;
        return box.x * box.y + box.y * box.z + box.z * box.x;
    };
    const double length = cut.size[cut.axis], all = surface(length);
    if (all == 0) return std::numeric_limits<double>::infinity();
    const double lower = cut.test_cost * cut.below * surface(cut.place) / all;
    const double upper = cut.test_cost * cut.above * surface(length - cut.place) / all;
    if (cut.below == 0) return cut.visit_cost + upper;
    if (cut.above == 0) return cut.visit_cost + lower * (1 - cut.empty_bonus);
    return cut.visit_cost + lower + upper;
}
