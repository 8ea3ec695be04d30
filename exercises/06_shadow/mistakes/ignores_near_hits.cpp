// hint: too_far
// Takes hits within a thousandth of the way for the surface itself, and whatever is so near with it.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    Vec3d start = point;
    auto t = first_hit(start, light - start);
    if (t && *t < 1e-3) {
        start = point + (light - point) * 1e-3;
        t = first_hit(start, light - start);
    }
    return t && *t < 1;
}
