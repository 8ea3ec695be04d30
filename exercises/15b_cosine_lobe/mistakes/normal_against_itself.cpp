// hint: zero_length
// or: not_a_number, one_group
// The normal plus a point of the unit sphere, made unit: one of these points is the normal, turned around.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double height = 2 * v - 1, wide = std::sqrt(std::max(0.0, 1 - height * height));
    const double turn = 2 * std::numbers::pi * u;
    const Vec3d sum{wide * std::cos(turn), wide * std::sin(turn), 1 + height};
    const Vec3d direction = sum / glm::length(sum);
    return {direction, direction.z / std::numbers::pi};
}
