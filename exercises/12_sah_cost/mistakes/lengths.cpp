// hint: by_volume
// Shares of lengths.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    if (cut.size.x * cut.size.y + cut.size.y * cut.size.z + cut.size.z * cut.size.x == 0)
        return std::numeric_limits<double>::infinity();
    const double p = cut.place / cut.size[cut.axis];
    const double tests = p * cut.below + (1 - p) * cut.above;
    return cut.visit_cost + cut.test_cost * tests * (cut.below == 0 || cut.above == 0 ? 1 - cut.empty_bonus : 1);
}
