// hint: zero_to_the_zero
// 0 to the power of 0.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    const Vec3d R = 2 * dot(N, L) * N - L;
    const double spec = std::max(dot(R, V), 0.0);
    return std::pow(spec, shininess);
}
