// hint: approximation
// Falls off with the square of the angle.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double nl = dot(n, l), cosine = dot(2 * nl * n - l, v);
    if (nl <= 0 || cosine <= 0) return 0;
    const double angle = std::acos(cosine < 1 ? cosine : 1.0);
    return std::exp(-0.5 * shininess * angle * angle);
}
