// hint: culling
// Only what faces the ray.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = cross(e1, e2);
    const double det = -dot(ray.direction, n);
    if (det <= 0) return std::nullopt;
    const Vec3d ao = ray.origin - triangle.a, dao = cross(ao, ray.direction);
    const double u = dot(e2, dao) / det, v = -dot(e1, dao) / det, t = dot(ao, n) / det;
    if (u < 0 || v < 0 || u + v > 1 || t < ray.range.min || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
