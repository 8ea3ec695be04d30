// hint: chance_of_the_full
// Where one half is empty, every ray of the cell is thought to hit the other one.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const auto surface = [](const Vec3d& box) { return box.x * box.y + box.y * box.z + box.z * box.x; };
    const double all = surface(cut.size);
    if (all == 0) return std::numeric_limits<double>::infinity();
    const double kept = cut.test_cost * (1 - cut.empty_bonus);
    if (cut.below == 0) return cut.visit_cost + kept * cut.above;
    if (cut.above == 0) return cut.visit_cost + kept * cut.below;
    Vec3d lower = cut.size, upper = cut.size;
    lower[cut.axis] = cut.place;
    upper[cut.axis] -= cut.place;
    return cut.visit_cost + cut.test_cost * (surface(lower) * cut.below + surface(upper) * cut.above) / all;
}
