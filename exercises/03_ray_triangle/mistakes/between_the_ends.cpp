// hint: closed_range
// A matrix solves the three equations, and the t of its solution has to lie between the ends.
#include "raylab/geometry/triangle_hit.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const glm::dmat3 system(triangle.b - triangle.a, triangle.c - triangle.a, -ray.direction);
    if (glm::determinant(system) == 0) return std::nullopt;
    const Vec3d uvt = glm::inverse(system) * (ray.origin - triangle.a);
    const bool is_inside = uvt.x >= 0 && uvt.y >= 0 && uvt.x + uvt.y <= 1;
    const bool is_in_range = uvt.z > ray.range.min && uvt.z < ray.range.max;
    if (!is_inside || !is_in_range) return std::nullopt;
    return TriangleHit{uvt.z, uvt.x, uvt.y};
}
