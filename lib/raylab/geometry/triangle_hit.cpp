#include "raylab/geometry/triangle_hit.h"

#include <algorithm>

// Signed volumes: with the ray's origin moved to zero, direction . (p x q) is six times the volume of the tetrahedron over
// the edge pq, and its sign says on which side of that edge the ray passes. Chapter 03, equations (3) and (4).

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d a = triangle.a - ray.origin;
    const Vec3d b = triangle.b - ray.origin;
    const Vec3d c = triangle.c - ray.origin;

    const double u = dot(ray.direction, cross(c, a));
    const double v = dot(ray.direction, cross(a, b));
    const double w = dot(ray.direction, cross(b, c));
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return std::nullopt;  // passes outside an edge

    const double volume = u + v + w;
    if (volume == 0) return std::nullopt;  // the ray lies in the plane, or the triangle has no area

    const double t = dot(a, cross(b, c)) / volume;
    if (t < ray.range.min || t > ray.range.max) return std::nullopt;
    return TriangleHit{t, u / volume, v / volume};
}
