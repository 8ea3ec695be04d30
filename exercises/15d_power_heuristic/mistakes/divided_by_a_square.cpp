// hint: other_not_squared
// Divides above and below by the square of pdf, and what stood below was not the square of the other density.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    const double ratio = other / pdf / pdf;
    return 1 / (1 + ratio);
}
