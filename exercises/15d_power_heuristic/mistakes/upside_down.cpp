// hint: reciprocal
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    double r = other / pdf;
    return 1 + r * r;
}
