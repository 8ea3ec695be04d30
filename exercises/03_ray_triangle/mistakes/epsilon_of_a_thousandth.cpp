// hint: epsilon
// The usual epsilon against parallel rays.
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    constexpr double EPSILON = 1e-6;
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, h = cross(ray.direction, e2);
    const double det = dot(e1, h);
    if (std::abs(det) < EPSILON) return std::nullopt;
    const double f = 1.0 / det;
    const Vec3d s = ray.origin - triangle.a, q = cross(s, e1);
    const double u = f * dot(s, h), v = f * dot(ray.direction, q), t = f * dot(e2, q);
    if (u < 0 || v < 0 || u + v > 1 || t < ray.range.min || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
