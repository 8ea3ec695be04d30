// hint: density_at_the_horizon
// Adds a millionth to the density, so that nobody divides by 0.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double wide = std::sqrt(u), turn = 2 * std::numbers::pi * v;
    const Vec3d direction{wide * std::cos(turn), wide * std::sin(turn), std::sqrt(1 - u)};
    return {direction, direction.z / std::numbers::pi + 1e-6};
}
