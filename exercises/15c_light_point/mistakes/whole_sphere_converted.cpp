// hint: whole_sphere
#include "raylab/transport/light/light_point.h"

#include <cmath>
#include <numbers>

raylab::LightPoint raylab::light_point(const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
    const double z = 1 - 2 * u, r = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * v;
    const Vec3d normal{r * std::cos(angle), r * std::sin(angle), z};
    const Vec3d point = center + radius * normal;
    const Vec3d way = from - point;
    const double squared = dot(way, way), cosine = std::abs(dot(way, normal)) / std::sqrt(squared);
    return {point, squared / (cosine * 4 * std::numbers::pi * radius * radius)};
}
