// Three equations for t, u and v, given to a matrix.
#include "raylab/geometry/triangle_hit.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const glm::dmat3 system(-ray.direction, triangle.b - triangle.a, triangle.c - triangle.a);
    if (glm::determinant(system) == 0) return std::nullopt;
    const Vec3d solution = glm::inverse(system) * (ray.origin - triangle.a);
    const TriangleHit hit{solution.x, solution.y, solution.z};
    const bool inside = hit.u >= 0 && hit.v >= 0 && hit.u + hit.v <= 1;
    return inside && contains(ray.range, hit.t) ? std::optional(hit) : std::nullopt;
}
