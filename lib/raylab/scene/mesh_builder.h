#pragma once

#include "raylab/base/error.h"
#include "raylab/base/memory_limit.h"
#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// The bytes that a mesh's lists take.
double bytes_of(const Mesh& mesh);

/// Collects the parts of a mesh while a file is read, and enforces what all formats require: counts for which the file
/// has room, finite numbers, indices in range, polygons of at least three corners, at least one face, and no more
/// memory than the limit.
class MeshBuilder {
public:
    /// `where` returns the place in the file that is being read, for messages.
    MeshBuilder(std::function<Place()> where, const MemoryLimit& limit) : where_(std::move(where)), limit_(limit) {}

    /// Checks a count that the file gives. It throws an Error where the rest of the file is too short for that many, so
    /// that no memory is allocated only because a file asks for it.
    std::size_t count(std::string_view of_what, std::int64_t given, std::size_t room) const;

    /// Returns the vector. It throws an Error where one of its numbers is not finite.
    const Vec3f& finite(const Vec3f& vector) const;

    void vertex(const Vec3f& position) { append(mesh_.vertices, finite(position)); }
    void normal(const Vec3f& direction) { append(mesh_.normals, finite(direction)); }

    /// Appends to a list that a reader keeps beside the mesh: its memory counts as the mesh's does.
    template <class Item>
    void keep(std::vector<Item>& list, const Item& item) {
        const std::size_t before = list.capacity();
        append(list, item);
        beside_ += static_cast<double>((list.capacity() - before) * sizeof(Item));
    }

    std::size_t vertex_count() const { return mesh_.vertices.size(); }

    /// Adds a polygon as a fan of triangles about its first corner. Corners count from 0 and lie below `vertex_count`,
    /// which a format may know before it has given the vertices.
    void polygon(std::span<const std::int64_t> corners, std::size_t vertex_count);

    /// Returns the mesh; throws an Error where it has no face.
    Mesh finish();

private:
    template <class Item>
    void append(std::vector<Item>& list, const Item& item) {
        if (list.size() == list.capacity()) check_growth(2.0 * static_cast<double>(list.size() * sizeof(Item)));
        list.push_back(item);
    }
    void check_growth(double more) const;

    std::function<Place()> where_;
    MemoryLimit limit_;
    Mesh mesh_;
    double beside_ = 0;  // bytes of the lists beside it
};

}  // namespace raylab
