// hint: reciprocal
// Divides the sum of both squares by one of them. The square belongs above.
#include "raylab/transport/power_heuristic.h"

#include <algorithm>
#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double larger = std::max(pdf, other);
    if (std::isinf(larger)) return pdf == larger ? 1 : larger;
    const double mine = std::pow(pdf / larger, 2), theirs = std::pow(other / larger, 2);
    return (mine + theirs) / mine;
}
