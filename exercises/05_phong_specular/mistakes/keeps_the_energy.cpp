// hint: scaled
// The modified model's factor, (n + 2) / (2 pi).
#include "raylab/tracer/phong_specular.h"

#include <cmath>
#include <numbers>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double incline = dot(n, l), cosine = 2 * incline * dot(n, v) - dot(l, v);
    if (incline <= 0 || cosine <= 0) return 0;
    return (shininess + 2) / (2 * std::numbers::pi) * std::pow(cosine, shininess);
}
