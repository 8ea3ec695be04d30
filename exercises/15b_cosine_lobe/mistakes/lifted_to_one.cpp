// hint: lifted_to_one
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double r = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return {glm::normalize(Vec3d{r * std::cos(angle), r * std::sin(angle), 1}), std::sqrt(1 - u) / std::numbers::pi};
}
