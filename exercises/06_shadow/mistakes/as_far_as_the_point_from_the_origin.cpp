// hint: too_near
// The offset is a share of the point's distance from the origin: at the origin there is none, however far the light is.
#include "raylab/tracer/in_shadow.h"

#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d lifted = point + 1e-9 * std::sqrt(dot(point, point)) * normal;
    const Vec3d way = light - lifted;
    const double distance = glm::length(way);
    if (dot(light - point, normal) <= 0) return true;
    return first_hit(lifted, way / distance).value_or(distance) < distance * (1 - 1e-9);
}
