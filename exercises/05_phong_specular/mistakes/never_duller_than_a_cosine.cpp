// hint: least_exponent
// The exponent is 1 at least.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double nl = dot(n, l);
    if (nl <= 0) return 0;
    const double cosine = dot(2 * nl * n - l, v);
    return cosine > 0 ? std::pow(cosine, shininess < 1 ? 1 : shininess) : 0;
}
