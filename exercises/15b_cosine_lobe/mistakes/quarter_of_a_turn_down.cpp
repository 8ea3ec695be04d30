// hint: even_angle
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double up = std::numbers::pi / 2 * v, around = 2 * std::numbers::pi * u;
    const Vec3d d{std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up)};
    return {d, d.z / std::numbers::pi};
}
