// hint: root
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (pdf >= other) {
        const double ratio = other / pdf;
        return 1 / std::sqrt(1 + ratio * ratio);
    }
    const double ratio = pdf / other;
    return ratio / std::sqrt(1 + ratio * ratio);
}
