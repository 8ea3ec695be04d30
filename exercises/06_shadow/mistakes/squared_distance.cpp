// hint: units_of_t
// Compares a distance with the squared distance of the light.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light - point) <= 0) return true;
    const double size = glm::length(point) + glm::length(light);
    const Vec3d start = point + normal * (1e-10 * size);
    const auto t = first_hit(start, glm::normalize(light - start));
    return t && *t < dot(light - start, light - start);
}
