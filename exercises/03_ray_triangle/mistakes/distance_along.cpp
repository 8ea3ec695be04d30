// hint: unit_direction
// or: another_question
// A unit direction, and t in metres.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d d = glm::normalize(ray.direction),
                n = glm::normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    if (dot(n, d) == 0) return std::nullopt;
    const double t = dot(n, triangle.a - ray.origin) / dot(n, d);
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d p = ray.origin + t * d - triangle.a, e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const double aa = dot(e1, e1), ab = dot(e1, e2), bb = dot(e2, e2), det = aa * bb - ab * ab;
    const double u = (bb * dot(p, e1) - ab * dot(p, e2)) / det, v = (aa * dot(p, e2) - ab * dot(p, e1)) / det;
    return u >= 0 && v >= 0 && u + v <= 1 ? std::optional(TriangleHit{t, u, v}) : std::nullopt;
}
