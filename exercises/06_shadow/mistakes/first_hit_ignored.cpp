// hint: starts_on_surface
// Starts at the point, and takes a first hit close to it for nothing in the way: it never sees what stands behind.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d to_light = light - point;
    if (dot(normal, to_light) <= 0) return true;
    const auto t = first_hit(point, to_light);
    const bool is_something = t && *t > 1e-7;
    return is_something && *t < 1 - 1e-9;
}
