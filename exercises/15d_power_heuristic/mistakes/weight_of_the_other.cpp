// hint: swapped
#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    const double mine = std::hypot(1.0, pdf / other);
    return 1 / (mine * mine);
}
