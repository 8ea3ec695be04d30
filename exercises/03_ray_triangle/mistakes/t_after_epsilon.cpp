// hint: own_limits
// or: range
// t must be positive, as the paper has it, and below the range's end.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, h = cross(ray.direction, e2);
    const double det = dot(e1, h);
    if (det == 0) return std::nullopt;
    const Vec3d s = ray.origin - triangle.a, q = cross(s, e1);
    const double u = dot(s, h) / det, v = dot(ray.direction, q) / det, t = dot(e2, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || t <= 0 || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
