// hint: to_light
// The logarithm of the cosine between viewer and light, times the shininess: the mirror direction is missing.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const bool is_lit = dot(normal, to_light) > 0;
    const double along = dot(to_light, to_viewer);
    if (!is_lit || along <= 0) return 0;
    const double squares = dot(to_light, to_light) * dot(to_viewer, to_viewer);
    return std::exp(shininess * (std::log(along) - std::log(squares) / 2));
}
