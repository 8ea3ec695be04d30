// hint: rest_of_area
// Mixes the two counts by the chance of the lower half, as if a ray that misses it hit the upper one and no other did.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <cmath>
#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const int b = (cut.axis + 1) % 3, c = (cut.axis + 2) % 3;
    const double face = cut.size[b] * cut.size[c], rim = cut.size[b] + cut.size[c];
    const double whole = face + rim * cut.size[cut.axis];
    if (whole <= 0) return std::numeric_limits<double>::infinity();
    const double chance = (face + rim * cut.place) / whole;
    double tests = std::lerp(cut.above, cut.below, chance);
    if (cut.below * cut.above == 0) tests -= cut.empty_bonus * tests;
    return cut.visit_cost + cut.test_cost * tests;
}
