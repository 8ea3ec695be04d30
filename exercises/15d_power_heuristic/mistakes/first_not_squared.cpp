// hint: other_not_squared
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    return 1 / (1 + other / pdf * other);
}
