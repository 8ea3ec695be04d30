// hint: nothing_unit
// or: zero_to_the_zero
// The formula as it stands, for vectors as they come.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d &n = normal, &l = to_light, &v = to_viewer;
    if (dot(n, l) <= 0) return 0;
    const Vec3d r = 2 * dot(n, l) * n - l;
    return std::pow(std::max(0.0, dot(r, v)), shininess);
}
