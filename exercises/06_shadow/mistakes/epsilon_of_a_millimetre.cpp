// hint: too_far
// An epsilon of a millimetre.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d L = light - point;
    if (dot(L, normal) <= 0) return true;
    const auto hit = first_hit(point + 0.001 * normal, L);
    return hit.has_value() && *hit < 1.0;
}
