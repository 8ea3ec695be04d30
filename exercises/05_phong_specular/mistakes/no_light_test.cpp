// hint: light_behind
// Does not ask on which side the light is.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    const double c = dot(2 * dot(N, L) * N - L, V);
    if (c <= 0) return 0;
    return std::pow(c, shininess);
}
