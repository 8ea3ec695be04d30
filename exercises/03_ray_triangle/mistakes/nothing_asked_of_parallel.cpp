// hint: parallel
// or: not_a_number
// Divides by a slope of 0, and compares so that NaN passes.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double t = dot(n, triangle.a - ray.origin) / dot(n, ray.direction);
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d p = ray.origin + t * ray.direction;
    const double u = dot(n, cross(p - triangle.a, triangle.c - triangle.a)) / dot(n, n);
    const double v = dot(n, cross(triangle.b - triangle.a, p - triangle.a)) / dot(n, n);
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    return TriangleHit{t, u, v};
}
