#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// Collects a mesh as a reader meets it, and keeps the promises that all formats share: counts that the file has room
/// for, finite numbers, indices in range, polygons of at least three corners, at least one face.
class MeshBuilder {
public:
    /// `where` tells the place in the file that is being read, for messages.
    explicit MeshBuilder(std::function<Place()> where) : where_(std::move(where)) {}

    /// A count as the file gives it. Error where it is more than the rest of the file has room for, so that nothing is
    /// allocated on a file's word alone.
    std::size_t count(std::string_view of_what, std::int64_t given, std::size_t room) const;

    /// The vector. Error where one of its numbers is not finite.
    const Vec3f& finite(const Vec3f& vector) const;

    void vertex(const Vec3f& position) { mesh_.vertices.push_back(finite(position)); }
    void normal(const Vec3f& direction) { mesh_.normals.push_back(finite(direction)); }
    std::size_t vertex_count() const { return mesh_.vertices.size(); }

    /// Fanned from the first corner. Corners count from 0 and lie below `vertex_count`, which a format may know before
    /// it has given the vertices.
    void polygon(std::span<const std::int64_t> corners, std::size_t vertex_count);

    /// The mesh; Error where it has no face.
    Mesh finish();

private:
    std::function<Place()> where_;
    Mesh mesh_;
};

}  // namespace raylab
