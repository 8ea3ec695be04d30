// hint: factor
// The cosine over its mean, 1/2, is shared among the directions of a whole sphere, where half of them are meant.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double height = 1 - 2 * u, wide = 2 * std::sqrt(u) * std::sqrt(1 - u), turn = 2 * std::numbers::pi * v;
    const Vec3d on_sphere{wide * std::cos(turn), wide * std::sin(turn), height};
    const Vec3d direction = glm::normalize(on_sphere + Vec3d{0, 0, 1});
    const double beside_the_mean = direction.z / 0.5, all_directions = 4 * std::numbers::pi;
    return {direction, beside_the_mean / all_directions};
}
