// hint: too_near
// or: starts_on_surface, rises_too_little
// A fixed epsilon that is too small for large coordinates.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d way = light - point;
    if (dot(way, normal) <= 0) return true;
    const auto t = first_hit(point + 1e-8 * normal, way);
    return t && *t < 1 - 1e-9;
}
