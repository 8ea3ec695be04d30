#include "raylab/geometry/triangle_hit.h"

#include <algorithm>

// Signed volumes: with the ray's origin moved to zero, direction . (p x q) is six times the volume of the tetrahedron
// over the edge pq, and its sign says on which side of that edge the ray passes. Chapter 03, equation (4).

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d a = triangle.a - ray.origin;
    const Vec3d b = triangle.b - ray.origin;
    const Vec3d c = triangle.c - ray.origin;

    // (p + q) x (q - p) is 2 p x q, but does not cancel when the triangle is small and far away.
    const double u = dot(ray.direction, cross(c + a, a - c));
    const double v = dot(ray.direction, cross(a + b, b - a));
    const double w = dot(ray.direction, cross(b + c, c - b));
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return std::nullopt;  // the ray passes outside an edge

    const double volume = u + v + w;
    if (volume == 0) return std::nullopt;  // the ray lies in the plane, or the triangle has no area

    const Vec3d normal = cross(b - a, c - a);
    const double t = dot(normal, a) / dot(normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHit{t, u / volume, v / volume};
}
