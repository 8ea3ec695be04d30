#pragma once

#include "raylab/geometry/shapes.h"

#include <cassert>
#include <cstddef>
#include <vector>

namespace raylab {

/// A polygon prepared for many rays, in the number type a method computes in.
template <Real T>
struct PolygonIn {
    std::vector<Vec3<T>> vertices;
    Vec3<T> normal{0, 0, 0};  // Newell's, not unit: its length is twice the polygon's area

    explicit PolygonIn(const Polygon& polygon) {
        assert(polygon.vertices.size() >= 3);
        for (const auto& vertex : polygon.vertices) vertices.push_back(convert<T>(vertex));
        // Vertices are taken relative to the first one, not to the world's origin: the same sum, without its
        // cancellation.
        for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
            normal += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
    }

    const Vec3<T>& after(std::size_t i) const { return vertices[i + 1 == vertices.size() ? 0 : i + 1]; }
};

}  // namespace raylab
