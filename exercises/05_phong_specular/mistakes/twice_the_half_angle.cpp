// hint: in_the_plane
// Takes twice the half vector's angle for the angle to the mirror direction.
#include "raylab/tracer/phong_specular.h"

#include <algorithm>
#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double nl = dot(n, l);
    if (nl <= 0) return 0;
    const Vec3d half = l + v;
    const double square = dot(n, half) * dot(n, half) / dot(half, half);
    const double cosine = 2 * square - 1;  // of the double angle
    return cosine > 0 ? std::pow(cosine, shininess) : 0;
}
