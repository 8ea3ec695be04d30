// hint: squares_leave_the_doubles
// Guards the infinite densities alone.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other)) return 0;
    return std::pow(pdf, 2) / (std::pow(pdf, 2) + std::pow(other, 2));
}
