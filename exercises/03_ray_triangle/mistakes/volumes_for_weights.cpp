// hint: not_divided
// The volumes between the ray and two edges decide rightly, and are given as weights before anything divides them.
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
    const double by_a = dot(ray.direction, cross(b, c));
    const double by_b = dot(ray.direction, cross(c, a));
    const double by_c = dot(ray.direction, cross(a, b));
    const bool is_front = by_a >= 0 && by_b >= 0 && by_c >= 0;
    const bool is_back = by_a <= 0 && by_b <= 0 && by_c <= 0;
    const double whole = by_a + by_b + by_c;
    if ((!is_front && !is_back) || whole == 0) return std::nullopt;

    const double t = dot(a, cross(b, c)) / whole;
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHit{t, std::abs(by_b), std::abs(by_c)};
}
