// hint: mirror_not_doubled
// The mirror direction without its 2.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    const double c = dot(dot(N, L) * N - L, V);
    return c > 0 ? std::pow(c, shininess) : 0;
}
