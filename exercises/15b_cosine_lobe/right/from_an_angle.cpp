#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double below = std::acos(1 - 2 * v) / 2, angle = -2 * std::numbers::pi * u;
    const Vec3d direction{std::sin(below) * std::sin(angle), std::sin(below) * std::cos(angle), std::cos(below)};
    return {direction, direction.z / std::numbers::pi};
}
