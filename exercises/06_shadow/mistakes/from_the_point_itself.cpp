// hint: starts_on_surface
// Starts on the surface itself.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d L = light - point;
    if (dot(L, normal) <= 0) return true;
    const double distance = glm::length(L);
    const auto hit = first_hit(point, L / distance);
    return hit && *hit < distance * (1 - 1e-9);
}
