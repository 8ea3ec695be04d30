// hint: starts_on_surface
// In metres, from the point itself: a hit that can only be the own surface ends the search, as if the way were free.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const double distance = glm::length(light - point);
    const Vec3d to_light = (light - point) / distance;
    if (!(dot(to_light, normal) > 0)) return true;
    const double reached = first_hit(point, to_light).value_or(distance);
    if (reached < 1e-7 * distance) return false;
    return reached < distance * (1 - 1e-9);
}
