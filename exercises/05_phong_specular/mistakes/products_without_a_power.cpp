// hint: exponent_forgotten
// Multiplies out R.V = 2 (N.L)(N.V) - L.V and gives that, without a power.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double) {
    const auto cosine = [](const Vec3d& a, const Vec3d& b) { return dot(a, b) / (glm::length(a) * glm::length(b)); };
    const double nl = cosine(normal, to_light), nv = cosine(normal, to_viewer), lv = cosine(to_light, to_viewer);
    if (nl <= 0) return 0;
    return std::max(2 * nl * nv - lv, 0.0);
}
