// A unit direction, and t compared with the light's distance.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    double size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(point[i]), std::abs(light[i])});
    const Vec3d start = point + 1e-9 * size * normal;
    const Vec3d way = light - start;
    const double distance = std::sqrt(dot(way, way));
    if (dot(way, normal) <= 0) return true;
    const auto t = first_hit(start, way / distance);
    return t.has_value() && *t < distance * (1 - 1e-9);
}
