#include "raylab/transport/power_heuristic.h"

#include <algorithm>
#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double larger = std::max(pdf, other);
    if (std::isinf(larger)) return pdf == larger ? 1 : 0;
    const double a = pdf / larger, b = other / larger;
    return a * a / (a * a + b * b);
}
