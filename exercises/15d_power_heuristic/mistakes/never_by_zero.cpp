// hint: small_ones_are_nothing
// Something small is added, so that nothing is divided by zero.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (std::isinf(other)) return 0;
    return pdf * pdf / (pdf * pdf + other * other + 1e-6);
}
