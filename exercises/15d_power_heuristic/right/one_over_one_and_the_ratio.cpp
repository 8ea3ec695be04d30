#include "raylab/transport/power_heuristic.h"

double raylab::power_heuristic(double pdf, double other) {
    // An infinite ratio, and the square of a large one, make the weight 0, as they should; an infinite pdf makes the
    // ratio 0.
    const double ratio = other / pdf;
    return 1 / (1 + ratio * ratio);
}
