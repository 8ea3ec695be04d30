// hint: inside
// Intersects the plane only and does not test the edges.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d ab = triangle.b - triangle.a;
    const Vec3d ac = triangle.c - triangle.a;
    const Vec3d normal = cross(ab, ac);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, triangle.a - ray.origin) / slope;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    const Vec3d point = ray.origin + t * ray.direction - triangle.a;
    const double u = dot(normal, cross(point, ac)) / dot(normal, normal);
    const double v = dot(normal, cross(ab, point)) / dot(normal, normal);
    return TriangleHit{t, u, v};
}
