// hint: too_far
// A fixed offset that is small in a room, and large in a scene of a tenth of a millimetre.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(light - point, normal) <= 0) return true;
    const auto t = first_hit(point + 1e-5 * normal, light - point);
    return t && *t < 1 - 1e-7;
}
