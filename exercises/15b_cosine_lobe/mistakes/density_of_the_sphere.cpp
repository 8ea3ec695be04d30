// hint: factor
// Twice as many steradians as there are.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double theta = std::asin(std::sqrt(v)), phi = 2 * std::numbers::pi * u;
    const Vec3d d{std::sin(theta) * std::sin(phi), std::sin(theta) * std::cos(phi), std::cos(theta)};
    return {d, d.z / (2 * std::numbers::pi)};
}
