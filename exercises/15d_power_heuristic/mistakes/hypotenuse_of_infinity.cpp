// hint: infinity_over_infinity
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double share = pdf / 2 / std::hypot(pdf / 2, other / 2);
    return share * share;
}
