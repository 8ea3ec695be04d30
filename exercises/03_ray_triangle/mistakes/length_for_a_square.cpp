// hint: areas
// The normal's length, where its square belongs.
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d n = cross(b - a, c - a);
    const double down = dot(n, ray.direction);
    if (down == 0) return std::nullopt;
    const double t = dot(n, a - ray.origin) / down;
    const Vec3d p = ray.origin + t * ray.direction;
    const double u = dot(n, cross(a - c, p - c)) / glm::length(n);
    const double v = dot(n, cross(b - a, p - a)) / glm::length(n);
    if (!(u >= 0 && v >= 0 && u + v <= 1) || !contains(ray.range, t)) return std::nullopt;
    return TriangleHit{t, u, v};
}
