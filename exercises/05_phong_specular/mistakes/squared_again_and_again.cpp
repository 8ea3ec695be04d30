// hint: another_exponent
// The power by squares, for which the exponent has to be whole: its fraction is lost.
#include "raylab/tracer/phong_specular.h"

#include <cmath>
#include <glm/geometric.hpp>

double raylab::phong_specular(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d N = glm::normalize(normal), L = glm::normalize(to_light), V = glm::normalize(to_viewer);
    if (dot(N, L) <= 0) return 0;
    double square = dot(glm::reflect(-L, N), V);
    if (square <= 0) return 0;
    double power = 1;
    for (int exponent = static_cast<int>(shininess); exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) power *= square;
        square *= square;
    }
    return power;
}
