// hint: nothing_beside_zero
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    if (other == 0) return 0;
    if (pdf >= other) {
        const double ratio = other / pdf;
        return 1 / (1 + ratio * ratio);
    }
    const double ratio = pdf / other;
    return ratio * ratio / (1 + ratio * ratio);
}
