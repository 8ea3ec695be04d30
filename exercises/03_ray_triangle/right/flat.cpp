// Seen along the ray, the problem has two dimensions: is the origin inside a flat triangle?
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d along = ray.direction;
    const Vec3d aside = std::abs(along.x) < std::abs(along.y) ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d right = cross(along, aside);
    const Vec3d up = cross(right, along);
    const auto area = [&](const Vec3d& p, const Vec3d& q) {
        const Vec3d from = p - ray.origin, to = q - ray.origin;
        return dot(from, right) * dot(to, up) - dot(from, up) * dot(to, right);
    };
    const double of_a = area(triangle.b, triangle.c);
    const double of_b = area(triangle.c, triangle.a);
    const double of_c = area(triangle.a, triangle.b);
    const double whole = of_a + of_b + of_c;
    if (whole == 0) return std::nullopt;

    const double u = of_b / whole;
    const double v = of_c / whole;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    const Vec3d point = triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
    const double t = dot(point - ray.origin, along) / dot(along, along);
    return contains(ray.range, t) ? std::optional(TriangleHit{t, u, v}) : std::nullopt;
}
