// From the light to the point: nothing may come before the point itself, whose surface is met up to rounding.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d way = point - light;
    const double fall = -dot(way, normal);
    if (!(fall > 0)) return true;
    double size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(point[i]), std::abs(light[i])});
    const auto t = first_hit(light, way);
    return t && *t < 1 - 1e-11 * size / fall;
}
