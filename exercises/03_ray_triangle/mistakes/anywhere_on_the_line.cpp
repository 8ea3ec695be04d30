// hint: range
// The plane, then the three edges, and no question where on its line the point lies.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, a - ray.origin) / slope;
    const Vec3d point = ray.origin + t * ray.direction;

    const double beside_ab = dot(normal, cross(b - a, point - a));
    const double beside_bc = dot(normal, cross(c - b, point - b));
    const double beside_ca = dot(normal, cross(a - c, point - c));
    if (beside_ab < 0 || beside_bc < 0 || beside_ca < 0) return std::nullopt;
    const double whole = dot(normal, normal);
    return TriangleHit{t, beside_ca / whole, beside_ab / whole};
}
