// hint: negative_cosine
// Raises the cosine to the power whatever its sign.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0) return 0;
    const Vec3d r = 2 * dot(n, l) * n - l;
    return std::pow(dot(r, v), shininess);
}
