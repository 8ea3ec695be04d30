// Lengths are taken out of the cosine at the end, the power by a logarithm.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const double incline = dot(normal, to_light);
    if (!(incline > 0)) return 0;
    const Vec3d mirrored = (2 * incline / dot(normal, normal)) * normal - to_light;  // as long as to_light
    const double along = dot(mirrored, to_viewer);
    if (!(along > 0)) return 0;
    const double lengths = glm::length(to_light) * glm::length(to_viewer);
    return std::exp(shininess * std::log(along / lengths));
}
