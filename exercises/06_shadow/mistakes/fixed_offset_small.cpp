// hint: too_near
// An offset that is enough for a scene of some metres, in every scene.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const Vec3d start = point + normal * 1e-10;
    const auto t = first_hit(start, light - start);
    return t && *t < 1;
}
