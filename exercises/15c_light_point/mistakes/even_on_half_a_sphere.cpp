// hint: facing_hemisphere
// Points below the equator are mirrored to the side that faces the lit point.
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double z = 2 * v - 1, r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
    Vec3d normal{r * std::cos(phi), r * std::sin(phi), z};
    if (dot(normal, from - center) < 0) normal = -normal;
    const Vec3d point = center + radius * normal, way = from - point;
    const double cosine = dot(normal, glm::normalize(way));
    return {point, dot(way, way) / (2 * std::numbers::pi * radius * radius * std::abs(cosine))};
}
