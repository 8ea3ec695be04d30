// hint: density_at_the_horizon
// Keeps the density above a thousandth, so that nobody divides by 0.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double wide = std::sqrt(v), turn = 2 * std::numbers::pi * u;
    const Vec3d direction{wide * std::cos(turn), wide * std::sin(turn), std::sqrt(1 - v)};
    return {direction, std::max(0.001, direction.z / std::numbers::pi)};
}
