// hint: base_and_exponent
// exp(cosine log(shininess)), where exp(shininess log(cosine)) was meant.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const double facing = dot(normal, to_light);
    const Vec3d mirrored = 2.0 * facing / dot(normal, normal) * normal - to_light;
    const double cosine = dot(mirrored, to_viewer) / (glm::length(mirrored) * glm::length(to_viewer));
    if (facing <= 0 || cosine <= 0) return 0;
    return std::exp(cosine * std::log(shininess));
}
