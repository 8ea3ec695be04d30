// hint: too_near
// An offset that grows with the point's coordinates, and not with the light's.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const double size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    const Vec3d start = point + 1e-9 * size * normal;
    const auto t = first_hit(start, light - start);
    return t && *t < 1;
}
