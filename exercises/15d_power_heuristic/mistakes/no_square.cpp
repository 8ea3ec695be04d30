// hint: no_square
#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    if (pdf >= other) {
        const double ratio = other / pdf;
        return 1 / (1 + ratio);
    }
    const double ratio = pdf / other;
    return ratio / (1 + ratio);
}
