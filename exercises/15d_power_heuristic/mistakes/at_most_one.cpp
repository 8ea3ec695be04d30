// hint: ratio_alone
// The ratio of the squares, cut off at 1.
#include "raylab/transport/power_heuristic.h"

#include <algorithm>
#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (other == 0 || std::isinf(pdf)) return 1;
    const double ratio = pdf / other;
    return std::min(1.0, ratio * ratio);
}
