#pragma once

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/triangle_hit.h"

namespace raylab {

/// Intersects the plane, drops the normal's dominant axis, and solves for the barycentric coordinates in 2D by two
/// divisions. Source: Badouel, An Efficient Ray-Polygon Intersection, Graphics Gems, 1990, pp. 390-393. Weak spot: a
/// chain of divisions on a rounded point; the plane's distance from the world's origin.
template <Real T>
std::optional<TriangleHitOf<T>> badouel(const RayOf<T>& ray, const TriangleOf<T>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3<T> normal = cross(b - a, c - a);
    const T distance = -dot(a, normal);
    const T t = -(distance + dot(normal, ray.origin)) / dot(normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;

    const auto [x, y] = other_axes(dominant_axis(normal));
    const T px = ray.origin[x] + t * ray.direction[x] - a[x], py = ray.origin[y] + t * ray.direction[y] - a[y];
    const T bx = b[x] - a[x], by = b[y] - a[y];
    const T cx = c[x] - a[x], cy = c[y] - a[y];

    // p = u b + v c. The second form divides by b's first coordinate, the first is for where that is zero.
    const T v = bx == 0 ? px / cx : (py * bx - px * by) / (cy * bx - cx * by);
    if (!(v >= 0 && v <= 1)) return std::nullopt;
    const T u = bx == 0 ? (py - v * cy) / by : (px - v * cx) / bx;
    if (!(u >= 0 && u + v <= 1)) return std::nullopt;
    return TriangleHitOf<T>{t, u, v};
}

}  // namespace raylab
