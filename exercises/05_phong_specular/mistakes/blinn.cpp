// hint: half_vector
// Blinn's half vector.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    const Vec3d H = glm::normalize(L + V);
    return std::pow(std::max(dot(N, H), 0.0), shininess);
}
