// hint: closed_edges
// Goes round the triangle, and the point has to lie strictly to the left of each edge.
#include "raylab/geometry/triangle_hit.h"

#include <array>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const std::array corners{triangle.a, triangle.b, triangle.c};
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, corners[0] - ray.origin) / slope;
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3d point = ray.origin + t * ray.direction;
    std::array<double, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d edge = corners[(i + 1) % 3] - corners[i];
        sides[i] = dot(normal, cross(edge, point - corners[i]));
        if (!(sides[i] > 0)) return std::nullopt;
    }
    const double whole = sides[0] + sides[1] + sides[2];
    return TriangleHit{t, sides[2] / whole, sides[0] / whole};
}
