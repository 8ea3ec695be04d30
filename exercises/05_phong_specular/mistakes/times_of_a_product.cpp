// hint: another_exponent
// A loop of products: the fraction of the shininess is lost.
#include "raylab/tracer/phong_specular.h"

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d n = glm::normalize(normal), l = glm::normalize(to_light), v = glm::normalize(to_viewer);
    const double cosine = dot(2.0 * dot(n, l) * n - l, v);
    if (dot(n, l) <= 0 || cosine <= 0) return 0;
    double product = 1;
    for (int i = 1; i <= shininess; ++i) product *= cosine;
    return product;
}
