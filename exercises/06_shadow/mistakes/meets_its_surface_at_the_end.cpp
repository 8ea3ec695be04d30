// hint: starts_on_surface
// Asks from the light, and meets the surface itself just before the point.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const auto t = first_hit(light, point - light);
    return t && *t < 1;
}
