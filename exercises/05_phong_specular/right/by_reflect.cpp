// glm::reflect of the light's way in.
#include "raylab/tracer/phong_specular.h"

#include <cmath>
#include <glm/geometric.hpp>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    if (!(dot(N, L) > 0)) return 0;
    const double c = dot(glm::reflect(-L, N), V);
    return c > 0 ? std::pow(c, shininess) : 0;
}
