// hint: viewer_behind
// Takes the highlight from a viewer below the horizon.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0 || dot(n, v) <= 0) return 0;
    const Vec3d r = 2 * dot(n, l) * n - l;
    const double cosine = dot(r, v);
    return cosine <= 0 ? 0 : std::pow(std::min(1.0, cosine), shininess);
}
