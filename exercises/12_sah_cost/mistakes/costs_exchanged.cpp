// hint: test_cost
// Visit and test have changed places.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const int i = cut.axis, j = (i + 1) % 3, k = (i + 2) % 3;
    const double face = cut.size[j] * cut.size[k], around = cut.size[j] + cut.size[k];
    const double all = face + around * cut.size[i];
    if (!(all > 0)) return std::numeric_limits<double>::infinity();
    const double lower = (face + around * cut.place) / all, upper = (face + around * (cut.size[i] - cut.place)) / all;
    const double saved = cut.below > 0 && cut.above > 0 ? 0 : cut.empty_bonus;
    return cut.test_cost + cut.visit_cost * (1 - saved) * (lower * cut.below + upper * cut.above);
}
