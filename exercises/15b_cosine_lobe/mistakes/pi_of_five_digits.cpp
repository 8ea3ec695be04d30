// hint: pi_by_hand
// Writes pi as 3.1416, for the turn and for the density.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    constexpr double pi = 3.1416;
    const double wide = std::sqrt(u), z = std::sqrt(std::max(0.0, 1 - u)), turn = 2 * pi * v;
    return {{wide * std::cos(turn), wide * std::sin(turn), z}, z / pi};
}
