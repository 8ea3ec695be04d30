// The angle, by the arc cosine, and back.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (dot(N, L) <= 0) return 0;
    const Vec3d R = 2 * dot(N, L) * N - L;
    const double angle = std::atan2(glm::length(cross(R, V)), dot(R, V));
    return angle < 1.5707963267948966 ? std::pow(std::cos(angle), shininess) : 0;
}
