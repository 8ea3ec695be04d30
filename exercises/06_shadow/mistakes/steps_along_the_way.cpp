// hint: rises_too_little
// Steps a share of the way, however low the light stands.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const double size = glm::length(point) + glm::length(light);
    const Vec3d start = point + 5e-11 * size * glm::normalize(light - point);
    const auto t = first_hit(start, light - start);
    return t && *t < 1;
}
