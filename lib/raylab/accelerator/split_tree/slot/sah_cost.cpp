#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

namespace raylab {

double sah_cost(const SahCut& cut) {
    const double length = cut.size[cut.axis], a = cut.size[(cut.axis + 1) % 3], b = cut.size[(cut.axis + 2) % 3];
    const auto half_area = [&](double along) { return a * b + along * (a + b); };
    const double whole = half_area(length);
    if (!(whole > 0)) return std::numeric_limits<double>::infinity();
    const double tests = (half_area(cut.place) * cut.below + half_area(length - cut.place) * cut.above) / whole;
    const double saved = cut.below == 0 || cut.above == 0 ? cut.empty_bonus : 0;
    return cut.visit_cost + cut.test_cost * (1 - saved) * tests;
}

}  // namespace raylab
