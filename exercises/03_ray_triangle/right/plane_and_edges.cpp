// The plane first, then one side test an edge.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, a - ray.origin) / slope;
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3d point = ray.origin + t * ray.direction;
    const double beyond_ab = dot(normal, cross(b - a, point - a));
    const double beyond_bc = dot(normal, cross(c - b, point - b));
    const double beyond_ca = dot(normal, cross(a - c, point - c));
    if (beyond_ab < 0 || beyond_bc < 0 || beyond_ca < 0) return std::nullopt;
    const double whole = beyond_ab + beyond_bc + beyond_ca;
    return TriangleHit{t, beyond_ca / whole, beyond_ab / whole};
}
