// hint: too_near
// The offset is a share of the way to the light, which is no longer than the hair where the way is short.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d start = point + 1e-7 * glm::length(light - point) * normal, way = light - start;
    if (dot(normal, way) <= 0) return true;
    const auto t = first_hit(start, way);
    return t && *t < 1 - 1e-9;
}
