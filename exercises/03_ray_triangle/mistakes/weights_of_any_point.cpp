// hint: inside
// Two equations give each point of the plane its weights, and nobody asks for their signs.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = cross(e1, e2);
    const double down = dot(n, ray.direction);
    if (down == 0) return std::nullopt;
    const double t = dot(n, triangle.a - ray.origin) / down;
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3d q = ray.origin + t * ray.direction - triangle.a;
    const double aa = dot(e1, e1), ab = dot(e1, e2), bb = dot(e2, e2);
    const double aq = dot(e1, q), bq = dot(e2, q);
    const double determinant = aa * bb - ab * ab;
    return TriangleHit{t, (bb * aq - ab * bq) / determinant, (aa * bq - ab * aq) / determinant};
}
