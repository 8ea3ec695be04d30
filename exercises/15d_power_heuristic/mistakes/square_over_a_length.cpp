// hint: only_one_squared
// Divides by the root of the sum of squares.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other)) return 0;
    return pdf / std::hypot(pdf, other) * pdf;
}
