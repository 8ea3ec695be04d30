// hint: starts_on_surface
// Starts at the point itself.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const auto t = first_hit(point, light - point);
    return t && *t < 1;
}
