// An offset by the sum of all coordinates.
#include "raylab/tracer/in_shadow.h"

#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d way = light - point;
    if (!(dot(way, normal) > 0)) return true;
    const double sum = std::abs(point.x) + std::abs(point.y) + std::abs(point.z) + std::abs(light.x) +
                       std::abs(light.y) + std::abs(light.z);
    const Vec3d from = point + 1e-10 * sum * normal;
    if (const auto t = first_hit(from, light - from)) return *t < 1 - 1e-10;
    return false;
}
