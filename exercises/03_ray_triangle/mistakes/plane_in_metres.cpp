// hint: range_in_metres
// The way to the plane in metres is compared with the range, and then given as t.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double height = dot(normal, a - ray.origin), slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = height / slope;
    const double metres = t * glm::length(ray.direction);
    if (metres < ray.range.min || metres > ray.range.max) return std::nullopt;

    const Vec3d point = ray.origin + t * ray.direction;
    const auto area = [&](const Vec3d& from, const Vec3d& to) {
        return dot(normal, cross(to - from, point - from)) / dot(normal, normal);
    };
    const double of_a = area(b, c), of_b = area(c, a), of_c = area(a, b);
    if (of_a < 0 || of_b < 0 || of_c < 0) return std::nullopt;
    return TriangleHit{t, of_b, of_c};
}
