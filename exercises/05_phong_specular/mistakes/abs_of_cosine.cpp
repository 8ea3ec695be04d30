// hint: negative_cosine
// or: cut_after_power
// The absolute value of the cosine.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    return std::pow(std::abs(dot(2 * dot(N, L) * N - L, V)), shininess);
}
