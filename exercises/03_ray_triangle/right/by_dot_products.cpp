// The plane, then two equations with dot products (Ericson 2005).
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double nd = dot(n, ray.direction);
    if (nd == 0) return std::nullopt;
    const double t = dot(n, triangle.a - ray.origin) / nd;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d p = ray.origin + t * ray.direction;

    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, q = p - triangle.a;
    const double aa = dot(e1, e1), ab = dot(e1, e2), bb = dot(e2, e2), det = aa * bb - ab * ab;
    const double u = (bb * dot(q, e1) - ab * dot(q, e2)) / det, v = (aa * dot(q, e2) - ab * dot(q, e1)) / det;
    return u >= 0 && v >= 0 && u + v <= 1 ? std::optional(TriangleHit{t, u, v}) : std::nullopt;
}
