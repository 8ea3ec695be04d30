#pragma once

#include "raylab/geometry/triangle_hit.h"

#include <algorithm>
#include <cmath>

// A line through p and q has Pluecker coordinates (q - p, p x q): direction and moment. Two lines pass each other on
// the side given by the sign of the permuted inner product of their coordinates. Source: Shoemake, Pluecker Coordinate
// Tutorial, Ray Tracing News 11(1), 1998; Jones, Intersecting a Ray and a Triangle with Pluecker Coordinates, Ray
// Tracing News 13(1), 2000.

namespace raylab {

namespace detail {

/// The hit, once the ray's sides of the three edges are known; `sides` belong to the edges opposite a, b and c.
template <Real T>
std::optional<TriangleHitOf<T>> hit_between_edges(const RayOf<T>& ray, const TriangleOf<T>& triangle,
                                                  const Vec3<T>& sides) {
    const T smallest = std::min({sides.x, sides.y, sides.z}), greatest = std::max({sides.x, sides.y, sides.z});
    if (!(smallest >= 0 || greatest <= 0)) return std::nullopt;

    const Vec3<T> normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const T t = dot(normal, triangle.a - ray.origin) / dot(normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;

    const T whole = sides.x + sides.y + sides.z;
    if (whole == 0 || !std::isfinite(whole)) return std::nullopt;
    return TriangleHitOf<T>{t, sides.y / whole, sides.z / whole};
}

}  // namespace detail

/// All moments about the world's origin: an edge's moment could be stored with the mesh.
/// Weak spot: far from the world's origin the moments are large and cancel.
template <Real T>
std::optional<TriangleHitOf<T>> pluecker_in_world(const RayOf<T>& ray, const TriangleOf<T>& triangle) {
    const Vec3<T> ray_moment = cross(ray.origin, ray.direction);
    const auto side_of = [&](const Vec3<T>& p, const Vec3<T>& q) {
        return dot(ray.direction, cross(p, q)) + dot(ray_moment, q - p);
    };
    const auto& [a, b, c] = triangle;
    return detail::hit_between_edges(ray, triangle, Vec3<T>{side_of(b, c), side_of(c, a), side_of(a, b)});
}

/// Moments about the ray's origin, where the ray's own vanishes. An edge has the same number, but for its sign, in both
/// triangles that share it: no ray leaks through an edge.
/// Weak spot: at a vertex the sides of several edges are rounded independently.
template <Real T>
std::optional<TriangleHitOf<T>> pluecker(const RayOf<T>& ray, const TriangleOf<T>& triangle) {
    const Vec3<T> a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
    // (p + q) x (q - p) = 2 p x q, without the cancellation of two long vectors when the triangle is far away.
    const auto side_of = [&](const Vec3<T>& p, const Vec3<T>& q) { return dot(ray.direction, cross(p + q, q - p)); };
    return detail::hit_between_edges(ray, triangle, Vec3<T>{side_of(b, c), side_of(c, a), side_of(a, b)});
}

}  // namespace raylab
