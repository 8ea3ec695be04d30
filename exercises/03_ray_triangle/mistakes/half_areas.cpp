// hint: areas
// Areas of triangles over that of the parallelogram.
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, a - ray.origin) / slope;
    if (!contains(ray.range, t)) return std::nullopt;
    const Vec3d p = ray.origin + t * ray.direction;
    const auto area = [&](const Vec3d& x, const Vec3d& y) { return dot(normal, cross(x - p, y - p)) / 2; };
    const double u = area(c, a) / dot(normal, normal), v = area(a, b) / dot(normal, normal);
    if (u < 0 || v < 0 || area(b, c) < 0) return std::nullopt;
    return TriangleHit{t, u, v};
}
