// hint: beyond_the_light
// Takes every hit for an obstacle, the ones behind the light too.
// It shows in the traced scene.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const double size = glm::length(point) + glm::length(light);
    const Vec3d start = point + normal * (1e-10 * size);
    return first_hit(start, light - start).has_value();
}
