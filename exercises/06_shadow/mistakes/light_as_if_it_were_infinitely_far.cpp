// hint: light_is_a_place
// Asks for the side as of a light that is a direction, and then goes to a place.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d light_direction = glm::normalize(light);
    const bool is_lit_side = dot(light_direction, normal) > 0;
    const double size = glm::length(point) + glm::length(light);
    const Vec3d from = point + 1e-10 * size * normal;
    const double distance = glm::length(light - from);
    if (const auto t = first_hit(from, (light - from) / distance); t && *t < distance * (1 - 1e-10)) return true;
    return !is_lit_side;
}
