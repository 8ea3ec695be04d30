// hint: reciprocal
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double theta = std::asin(std::sqrt(u)), phi = 2 * std::numbers::pi * v;
    const Vec3d d{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    return {d, std::numbers::pi / d.z};
}
