#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other)) return 0;
    // Half of each, for the sum may be more than the largest double.
    const double cosine = pdf / 2 / std::hypot(pdf / 2, other / 2);
    return cosine * cosine;
}
