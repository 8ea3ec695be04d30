// hint: square_of_the_share
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    return std::pow(1 / (1 + other / pdf), 2);
}
