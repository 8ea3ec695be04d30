// hint: approximation
// Schlick's fraction in place of the power.
#include "raylab/tracer/phong_specular.h"

#include <cmath>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double nl = dot(n, l), cosine = dot(2 * nl * n - l, v);
    if (nl <= 0 || cosine <= 0) return 0;
    return cosine / (shininess - shininess * cosine + cosine);
}
