#include "raylab/scene/mesh_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace raylab {

double bytes_of(const Mesh& mesh) {
    return static_cast<double>(sizeof(Vec3f) * (mesh.vertices.capacity() + mesh.normals.capacity()) +
                               sizeof(Mesh::Face) * mesh.faces.capacity());
}

void MeshBuilder::check_growth(double more) const {
    check_memory({.bytes = bytes_of(mesh_) + beside_ + more,
                  .what = "a mesh",
                  .why = fmt::format("{} vertices and {} triangles so far", mesh_.vertices.size(), mesh_.faces.size())},
                 limit_, where_());
}

std::size_t MeshBuilder::count(std::string_view of_what, std::int64_t given, std::size_t room) const {
    if (given < 0 || static_cast<std::uint64_t>(given) > room)
        throw Error(where_(), fmt::format("at most {} {} (what the rest of the file has room for)", room, of_what),
                    std::to_string(given));
    return static_cast<std::size_t>(given);
}

const Vec3f& MeshBuilder::finite(const Vec3f& vector) const {
    if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z))
        throw Error(where_(), "three finite numbers that fit a float",
                    fmt::format("{} {} {}", vector.x, vector.y, vector.z));
    return vector;
}

void MeshBuilder::polygon(std::span<const std::int64_t> corners, std::size_t vertex_count) {
    if (corners.size() < 3) throw Error(where_(), "a polygon of at least 3 corners", std::to_string(corners.size()));
    for (const auto corner : corners)
        if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertex_count)
            throw Error(where_(), "the index of one of " + std::to_string(vertex_count) + " vertices, from 0",
                        std::to_string(corner));
    const auto vertex = [&](std::size_t corner) { return static_cast<std::uint32_t>(corners[corner]); };
    for (std::size_t last = 2; last < corners.size(); ++last)
        append(mesh_.faces, {vertex(0), vertex(last - 1), vertex(last)});
}

Mesh MeshBuilder::finish() {
    if (mesh_.faces.empty()) throw Error(where_(), "a mesh with at least one face", "none");
    return std::move(mesh_);
}

}  // namespace raylab
