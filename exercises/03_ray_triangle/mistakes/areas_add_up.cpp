// hint: own_tolerance
// Inside is where three areas add up to the whole, to a millionth of a square metre.
#include "raylab/geometry/triangle_hit.h"

#include <cmath>

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3d normal = cross(b - a, c - a);
    const double slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const double t = dot(normal, a - ray.origin) / slope;
    if (!contains(ray.range, t)) return std::nullopt;
    const Vec3d from_p_a = a - ray.origin - t * ray.direction, from_p_b = from_p_a + b - a, from_p_c = from_p_a + c - a;
    const double of_a = glm::length(cross(from_p_b, from_p_c)) / 2, of_b = glm::length(cross(from_p_c, from_p_a)) / 2,
                 of_c = glm::length(cross(from_p_a, from_p_b)) / 2, all = glm::length(normal) / 2;
    if (of_a + of_b + of_c > all + 1e-6) return std::nullopt;
    return TriangleHit{t, of_b / all, of_c / all};
}
