// hint: another_exponent
// Divides the exponent where another formula multiplies it.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (!(dot(n, l) > 0)) return 0;
    const Vec3d mirrored = 2.0 * dot(n, v) * n - v;
    const double cosine = std::clamp(dot(mirrored, l), 0.0, 1.0);
    return cosine > 0 ? std::pow(cosine, shininess / 4) : 0;
}
