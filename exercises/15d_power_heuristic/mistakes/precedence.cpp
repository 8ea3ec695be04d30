// hint: other_not_squared
// The power binds one of the two only.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other)) return 0;
    return pdf * pdf / (pdf * pdf + other);
}
