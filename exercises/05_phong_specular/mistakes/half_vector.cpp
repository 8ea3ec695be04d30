// hint: half_vector
// Blinn's half vector in place of Phong's mirror direction.
// It shows in the traced scene.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    if (dot(n, l) <= 0) return 0;
    const Vec3d h = glm::normalize(l + v);
    return std::pow(std::max(0.0, dot(n, h)), shininess);
}
