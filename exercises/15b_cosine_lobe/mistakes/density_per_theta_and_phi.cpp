// hint: pdf_per_angle
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double theta = std::asin(std::sqrt(v)), phi = 2 * std::numbers::pi * u;
    const Vec3d d{std::sin(theta) * std::sin(phi), std::sin(theta) * std::cos(phi), std::cos(theta)};
    return {d, std::sin(2 * theta) / (2 * std::numbers::pi)};
}
