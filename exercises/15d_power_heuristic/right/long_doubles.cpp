#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    const long double a = pdf, b = other;
    return static_cast<double>(a * a / (a * a + b * b));
}
