#pragma once

#include "raylab/experiment/ray_polygon/polygon_in.h"
#include "raylab/experiment/ray_triangle/moeller_trumbore.h"

namespace raylab {

/// The triangles from the first vertex to each edge, as a mesh reader makes them. For convex polygons: of a concave one
/// the fan also covers parts that are outside.
template <Real T>
std::optional<T> fan(const RayOf<T>& ray, const PolygonIn<T>& polygon) {
    const auto& vertices = polygon.vertices;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        if (const auto hit = moeller_trumbore(ray, TriangleOf<T>{vertices[0], vertices[i], vertices[i + 1]}))
            return hit->t;
    return std::nullopt;
}

}  // namespace raylab
