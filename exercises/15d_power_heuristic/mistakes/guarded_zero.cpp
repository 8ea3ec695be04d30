// hint: small_ones_are_nothing
// An epsilon keeps the sum from being 0.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other) || pdf + other < 1e-30) return 0;
    const double ratio = other / pdf;
    return 1 / (1 + ratio * ratio);
}
