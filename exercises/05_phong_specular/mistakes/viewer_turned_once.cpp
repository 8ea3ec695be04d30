// hint: mirror_not_doubled
// Mirrors the viewer by taking what is across the normal away once: it ends on the surface.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (!(dot(n, l) > 0)) return 0;
    const Vec3d upright = dot(n, v) * n;
    const Vec3d mirrored = upright - v;
    const double cosine = dot(mirrored, l);
    return cosine > 0 ? std::pow(cosine, shininess) : 0;
}
