// hint: cutoff
// A density of less than a hundredth of the other one is left out.
#include "raylab/transport/power_heuristic.h"

#include <algorithm>

double raylab::power_heuristic(double pdf, double other) {
    const double most = std::max(pdf, other), least = 0.01 * most;
    if (pdf < least) return 0;
    if (other < least) return 1;
    const double p = pdf / most, q = other / most;
    return p * p / (p * p + q * q);
}
