// hint: negative_cosine
// Mirrors the viewer, and raises what the light has along that to the power, if it is negative too.
#include "raylab/tracer/phong_specular.h"

#include <cmath>
#include <glm/geometric.hpp>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal);
    if (dot(n, to_light) <= 0) return 0;
    const Vec3d mirrored = glm::reflect(-to_viewer, n);  // as long as to_viewer
    const double along = dot(mirrored, to_light);
    return std::pow(along / (glm::length(to_viewer) * glm::length(to_light)), shininess);
}
