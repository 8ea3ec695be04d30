// hint: nothing_beside_zero
// Takes a density of 0 for a strategy that was not asked.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (!(pdf > 0 && other > 0)) return 0;
    const double cosine = std::cos(std::atan2(other, pdf));
    return cosine * cosine;
}
