// hint: range_in_metres
// Makes the direction unit, compares metres with the range, and gives t.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const double metres_per_t = glm::length(ray.direction);
    const Vec3d way = ray.direction / metres_per_t;
    const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, s = ray.origin - triangle.a;
    const Vec3d p = cross(way, ac), q = cross(s, ab);
    const double determinant = dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const double u = dot(s, p) / determinant, v = dot(way, q) / determinant, metres = dot(ac, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || !contains(ray.range, metres)) return std::nullopt;
    return TriangleHit{metres / metres_per_t, u, v};
}
