// hint: unit_direction
// or: another_question
// t is a distance, not a multiple of the direction.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d ab = triangle.b - triangle.a;
    const Vec3d ac = triangle.c - triangle.a;
    const Vec3d direction = glm::normalize(ray.direction);
    const Vec3d p = cross(direction, ac);
    const double determinant = dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const Vec3d s = ray.origin - triangle.a;
    const double u = dot(s, p) / determinant;
    if (u < 0 || u > 1) return std::nullopt;
    const Vec3d q = cross(s, ab);
    const double v = dot(direction, q) / determinant;
    if (v < 0 || u + v > 1) return std::nullopt;
    const double t = dot(ac, q) / determinant;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
