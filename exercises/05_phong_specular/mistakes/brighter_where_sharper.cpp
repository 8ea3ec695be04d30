// hint: scaled
// Half of n + 2 before the power.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0) return 0;
    const Vec3d r = glm::normalize(2.0 * dot(n, l) * n - l);
    const double c = std::max(0.0, dot(r, v));
    const double scale = 1 + shininess / 2;
    return c > 0 ? scale * std::pow(c, shininess) : 0;
}
