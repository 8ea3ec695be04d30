#pragma once

#include "raylab/geometry/triangle_hit.h"

#include <cmath>

namespace raylab {

/// Cramer's rule for o + t d = a + u (b - a) + v (c - a), with its two shared cross products.
/// Source: Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, journal of graphics tools 2(1), 1997.
/// Weak spot: neighbours compute their shared edge from different vertices, so rays leak between them or hit both.
///
/// `smallest_determinant` is the paper's absolute epsilon, as usually copied: triangles whose determinant is below it
/// vanish. It is here to be seen failing; zero (only truly parallel rays miss) is the honest value.
template <Real T>
std::optional<TriangleHitOf<T>> moeller_trumbore(const RayOf<T>& ray, const TriangleOf<T>& triangle,
                                                 T smallest_determinant = 0) {
    const Vec3<T> ab = triangle.b - triangle.a;
    const Vec3<T> ac = triangle.c - triangle.a;
    const Vec3<T> p = cross(ray.direction, ac);
    const T determinant = dot(ab, p);
    if (determinant == 0 || std::abs(determinant) < smallest_determinant) return std::nullopt;

    const Vec3<T> s = ray.origin - triangle.a;
    const T u = dot(s, p) / determinant;
    if (!(u >= 0 && u <= 1)) return std::nullopt;

    const Vec3<T> q = cross(s, ab);
    const T v = dot(ray.direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;

    const T t = dot(ac, q) / determinant;
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHitOf<T>{t, u, v};
}

}  // namespace raylab
