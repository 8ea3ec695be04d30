// hint: beyond_a_vertex
// Two of the three pairs of sides are compared, and 0 agrees with either sign.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
    const double by_a = dot(ray.direction, cross(c, b));
    const double by_b = dot(ray.direction, cross(a, c));
    const double by_c = dot(ray.direction, cross(b, a));
    const double sum = by_a + by_b + by_c;
    if (sum == 0) return std::nullopt;
    if (by_a * by_c < 0 || by_b * by_c < 0) return std::nullopt;
    const double u = by_b / sum, v = by_c / sum;
    const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double t = dot(normal, a) / dot(normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHit{t, u, v};
}
