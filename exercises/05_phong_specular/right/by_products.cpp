// Multiplies out: R.V = 2 (N.L)(N.V) - L.V, and no mirror direction is ever made.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double incline = dot(n, l);
    if (incline <= 0) return 0;
    const double cosine = std::min(1.0, 2 * incline * dot(n, v) - dot(l, v));
    return cosine <= 0 ? 0 : std::pow(cosine, shininess);
}
