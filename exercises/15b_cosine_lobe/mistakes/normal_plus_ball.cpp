// hint: not_unit
// The normal and a point of the unit sphere, added and not normalised.
#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    const double z = 2 * v - 1, r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
    const Vec3d sum = Vec3d{0, 0, 1} + Vec3d{r * std::sin(phi), r * std::cos(phi), z};
    return {sum, sum.z / std::numbers::pi};
}
