// hint: in_the_plane
// Compares the angles from the normal, whichever way round they are.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double nl = dot(n, l);
    if (nl <= 0) return 0;
    const double nv = dot(n, v);
    const double cosine = nl * nv + std::sqrt(std::max(0.0, (1 - nl * nl) * (1 - nv * nv)));
    return cosine > 0 ? std::pow(cosine, shininess) : 0;
}
