#include "raylab/sampling/mapping/cosine_direction.h"

#include <cmath>
#include <numbers>

raylab::SampledDirection raylab::cosine_direction(double u, double v) {
    // A point of the unit sphere that touches the surface from above, as seen from where it touches. The one point in
    // which both touch has no direction: it is the sphere's lowest, and 1 - 2 u is never -1.
    const double z = 1 - 2 * u, r = 2 * std::sqrt(u) * std::sqrt(1 - u), angle = 2 * std::numbers::pi * v;
    const Vec3d direction = glm::normalize(Vec3d{r * std::cos(angle), r * std::sin(angle), z + 1});
    return {direction, direction.z / std::numbers::pi};
}
