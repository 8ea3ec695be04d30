// hint: by_volume
// Uses the volume of each half instead of the probability that it is hit.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const double share = cut.place / cut.size[cut.axis];
    if (!(cut.size.x * cut.size.y + cut.size.y * cut.size.z + cut.size.z * cut.size.x > 0))
        return std::numeric_limits<double>::infinity();
    const double tests = share * cut.below + (1 - share) * cut.above;
    const double bonus = cut.below == 0 || cut.above == 0 ? cut.empty_bonus : 0;
    return cut.visit_cost + cut.test_cost * (1 - bonus) * tests;
}
