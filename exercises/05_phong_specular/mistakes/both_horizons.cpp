// hint: viewer_behind
// Asks where the viewer is, too.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0 || dot(N, V) < 0) return 0;
    const double c = dot(2 * dot(N, L) * N - L, V);
    return c > 0 ? std::pow(std::min(c, 1.0), shininess) : 0;
}
