// hint: not_divided
// u and v stay volumes.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, h = cross(ray.direction, e2);
    double det = dot(e1, h);
    if (det == 0) return std::nullopt;
    const double turn = det < 0 ? -1 : 1;
    det *= turn;
    const Vec3d s = (ray.origin - triangle.a) * turn, q = cross(s, e1);
    const double u = dot(s, h), v = dot(ray.direction, q), t = dot(e2, q) / det;
    if (u < 0 || v < 0 || u + v > det || t < ray.range.min || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u, v};
}
