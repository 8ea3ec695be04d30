// hint: one_square_below
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    const double ratio = other / pdf;
    return 1 / (pdf + pdf * ratio * ratio);
}
