// hint: nothing_unit
// or: light_not_unit, normal_not_unit
// Only the viewer's vector is normalised.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const double nl = dot(normal, to_light);
    if (nl <= 0) return 0;
    const double c = dot(2.0 * nl * normal - to_light, glm::normalize(to_viewer));
    return c <= 0 ? 0 : std::pow(c, shininess);
}
