// hint: own_limits
// Leaves out a thousandth at the range's beginning, against hits of what the ray leaves.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, s = ray.origin - triangle.a;
    const Vec3d p = cross(ray.direction, ac), q = cross(s, ab);
    const double determinant = dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const double u = dot(s, p) / determinant, v = dot(ray.direction, q) / determinant, t = dot(ac, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    if (t < ray.range.min + 1e-3 || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
