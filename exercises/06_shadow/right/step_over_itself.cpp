// Steps a little along the way, not along the normal, until it is above the surface surely.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d way = light - point;
    const double height = dot(normal, way);
    if (height <= 0) return true;
    const double size = glm::length(point) + glm::length(light);
    const double from = 1e-11 * size / height;  // the share of the way that rises so much
    const auto t = first_hit(point + from * way, way);
    return t && from + *t < 1;
}
