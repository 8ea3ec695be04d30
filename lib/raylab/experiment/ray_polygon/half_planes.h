#pragma once

#include "raylab/experiment/ray_polygon/polygon_in.h"
#include "raylab/geometry/ray.h"

#include <optional>

namespace raylab {

/// Intersects the plane, then asks of each edge whether the point is on its inner side. For convex polygons: of a
/// concave one it finds only the part that lies inside all its edges' half-planes.
template <Real T>
std::optional<T> half_planes(const RayOf<T>& ray, const PolygonIn<T>& polygon) {
    const T t = dot(polygon.normal, polygon.vertices[0] - ray.origin) / dot(polygon.normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;

    const Vec3<T> point = ray.origin + t * ray.direction;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vec3<T>& vertex = polygon.vertices[i];
        if (!(dot(polygon.normal, cross(polygon.after(i) - vertex, point - vertex)) >= 0)) return std::nullopt;
    }
    return t;
}

}  // namespace raylab
