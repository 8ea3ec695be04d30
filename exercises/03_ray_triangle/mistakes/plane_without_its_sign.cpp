// hint: signs
// or: turned_sign, range
// The plane's distance with a wrong sign.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double nd = dot(n, ray.direction);
    if (nd == 0) return std::nullopt;
    const double t = -dot(n, triangle.a - ray.origin) / nd;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d p = ray.origin + t * ray.direction;
    const double whole = dot(n, n);
    const double u = dot(n, cross(p - triangle.a, triangle.c - triangle.a)) / whole;
    const double v = dot(n, cross(triangle.b - triangle.a, p - triangle.a)) / whole;
    return u >= 0 && v >= 0 && u + v <= 1 ? std::optional(TriangleHit{t, u, v}) : std::nullopt;
}
