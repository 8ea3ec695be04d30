// hint: too_near
// An offset that grows with the way to the light, and not with the coordinates.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const Vec3d start = point + normal * (1e-9 * glm::length(light - point));
    const auto t = first_hit(start, light - start);
    return t && *t < 1;
}
