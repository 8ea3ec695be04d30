// hint: light_not_unit
// or: zero_to_the_zero
// Divides by the lengths of normal and viewer, and forgets that the light's is in both products, too.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const double nl = dot(normal, to_light), nv = dot(normal, to_viewer), lv = dot(to_light, to_viewer);
    if (nl <= 0) return 0;
    const double along = 2 * nl * nv / dot(normal, normal) - lv;
    if (along <= 0) return 0;
    return std::pow(along / glm::length(to_viewer), shininess);
}
