// hint: angle_for_cosine
// The angle's power.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    const double angle = std::acos(std::clamp(dot(2 * dot(N, L) * N - L, V), -1.0, 1.0));
    return angle < 1.5707963267948966 ? std::pow(angle, shininess) : 0;
}
