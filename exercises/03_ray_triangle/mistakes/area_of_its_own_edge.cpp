// hint: swapped
// Gives b the area at the edge from a to b, and c that at the edge from a to c.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, a - ray.origin) / slope;
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3d point = ray.origin + t * ray.direction;
    const auto share = [&](const Vec3d& from, const Vec3d& to) {
        return dot(normal, cross(from - point, to - point)) / dot(normal, normal);
    };
    const double of_b = share(a, b);
    const double of_c = share(c, a);
    const double of_a = share(b, c);
    if (of_a < 0 || of_b < 0 || of_c < 0) return std::nullopt;
    return TriangleHit{t, of_b, of_c};
}
