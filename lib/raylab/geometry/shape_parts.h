#pragma once

#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <variant>

// A shape taken apart into primitives: a mesh into its triangles, any other shape into itself.

namespace raylab {

/// The mesh that a shape is; null: it is another shape.
inline const Mesh* as_mesh(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape);
    return mesh ? mesh->get() : nullptr;
}

/// The number of primitives that a shape is taken apart into.
inline std::size_t part_count(const Shape& shape) {
    const Mesh* mesh = as_mesh(shape);
    return mesh ? mesh->faces.size() : 1;
}

/// The triangle that a part is; absent: it is none.
inline std::optional<Triangle> triangle_of(const Shape& shape, std::size_t part) {
    if (const Mesh* mesh = as_mesh(shape)) return mesh->triangle(part);
    const auto* triangle = std::get_if<Triangle>(&shape);
    return triangle ? std::optional(*triangle) : std::nullopt;
}

}  // namespace raylab
