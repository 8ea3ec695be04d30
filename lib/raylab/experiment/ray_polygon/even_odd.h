#pragma once

#include "raylab/experiment/ray_polygon/polygon_in.h"
#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/ray.h"

#include <optional>

namespace raylab {

/// Intersects the plane, drops the normal's dominant axis, and counts in 2D how many edges a half-line from the point
/// crosses: an odd number says inside. For every polygon, convex or not. Source: Haines, Point in Polygon Strategies,
/// Graphics Gems IV, 1994, pp. 24-46 (the crossings test).
template <Real T>
std::optional<T> even_odd(const RayOf<T>& ray, const PolygonIn<T>& polygon) {
    const T t = dot(polygon.normal, polygon.vertices[0] - ray.origin) / dot(polygon.normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3<T> point = ray.origin + t * ray.direction;
    const auto [x, y] = other_axes(dominant_axis(polygon.normal));
    bool inside = false;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec3<T> p = polygon.vertices[i] - point, q = polygon.after(i) - point;
        const T area = p[x] * q[y] - p[y] * q[x];  // its sign: on which side of the edge the point lies
        if (area == 0 && p[x] * q[x] <= 0 && p[y] * q[y] <= 0) return t;  // on the edge itself, which belongs to it
        const bool straddles = (p[y] > 0) != (q[y] > 0);
        if (straddles && (area > 0) == (q[y] > p[y])) inside = !inside;
    }
    return inside ? std::optional(t) : std::nullopt;
}

}  // namespace raylab
