// hint: ratio_alone
// Gives odds instead of a share.
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    if (other == 0) return 1;
    return pdf / other * (pdf / other);
}
