#include "raylab/transport/power_heuristic.h"

#include <cmath>

double raylab::power_heuristic(double pdf, double other) {
    // The weights of both are the squared cosine and the squared sine of one angle.
    const double cosine = std::cos(std::atan2(other, pdf));
    return cosine * cosine;
}
