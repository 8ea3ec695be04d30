// hint: half_vector
// Blinn's, with the exponent that makes it about as wide as Phong's.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0) return 0;
    const Vec3d half = glm::normalize(l + v);
    const double cosine = dot(n, half);
    return cosine > 0 ? std::pow(cosine, 4 * shininess) : 0;
}
