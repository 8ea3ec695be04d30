// hint: zero_to_the_zero
// Cuts off before the power, and 0 to the power of 0 is 1.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0) return 0;
    const Vec3d r = 2 * dot(n, l) * n - l;
    return std::pow(std::max(0.0, dot(r, v)), shininess);
}
