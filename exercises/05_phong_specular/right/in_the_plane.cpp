// L is split into what is along N and what is across.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);

    const double along = dot(N, L);
    if (along <= 0) return 0;
    const Vec3d across = L - along * N;
    const double c = dot(along * N - across, V);
    if (c <= 0) return 0;
    return std::pow(c, shininess);
}
