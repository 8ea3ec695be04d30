// hint: swapped
// Areas, of which each is given to the next vertex.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double nd = dot(n, ray.direction);
    if (nd == 0) return std::nullopt;
    const double t = dot(n, triangle.a - ray.origin) / nd;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d p = ray.origin + t * ray.direction;

    const double whole = dot(n, n);
    const double alpha = dot(n, cross(triangle.c - triangle.b, p - triangle.b)) / whole;
    const double beta = dot(n, cross(triangle.a - triangle.c, p - triangle.c)) / whole;
    const double gamma = 1 - alpha - beta;
    if (alpha < 0 || beta < 0 || gamma < 0) return std::nullopt;
    return TriangleHit{t, alpha, beta};
}
