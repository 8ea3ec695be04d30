// hint: times_lambert
// Times N.L, so that it fades.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    const double nl = dot(N, L);
    if (nl <= 0) return 0;
    const double c = dot(2 * nl * N - L, V);
    return c > 0 ? nl * std::pow(c, shininess) : 0;
}
