// hint: nothing_at_the_centre
// Squares around the middle become circles, and the middle itself a zero over a zero.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    constexpr double eighth = std::numbers::pi / 4;
    const double a = 2 * u - 1, b = 2 * v - 1;
    const bool is_beside = std::abs(a) >= std::abs(b);
    const double r = is_beside ? a : b, angle = is_beside ? eighth * (b / a) : 2 * eighth - eighth * (a / b);
    const Vec3d below{r * std::cos(angle), r * std::sin(angle), 0};
    const double z = std::sqrt(std::max(0.0, 1 - dot(below, below)));
    return {below + Vec3d{0, 0, z}, z / std::numbers::pi};
}
