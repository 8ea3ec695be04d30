// hint: base_and_exponent
// The arguments of pow in the wrong order.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double cosine = dot(2.0 * dot(n, l) * n - l, v);
    return dot(n, l) > 0 && cosine > 0 ? std::pow(shininess, cosine) : 0;
}
