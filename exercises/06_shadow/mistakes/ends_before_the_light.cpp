// hint: ends_before_the_light
// Stops at 98 hundredths of the way.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const double size = glm::length(point) + glm::length(light);
    const Vec3d start = point + normal * (1e-10 * size);
    const auto t = first_hit(start, light - start);
    return t && *t < 0.98;
}
