// hint: not_unit
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double z = 1 - 2 * u, r = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * v;
    const Vec3d direction{r * std::cos(angle), r * std::sin(angle), z + 1};
    return {direction, glm::normalize(direction).z / std::numbers::pi};
}
