#pragma once

#include "raylab/radiosity/mesh/polygonal_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

enum class FacetSide : std::uint8_t { front, back };

/// A piece of one side of a surface, taken to be equally bright everywhere.
struct Patch {
    std::array<Vec3d, 4> corners{};           // the first `corner_count` of them; counter-clockwise seen from its side
    std::array<std::uint32_t, 4> vertices{};  // of each corner, in PatchMesh::vertices
    std::uint32_t corner_count = 0;           // 3 or 4
    std::uint32_t facet = 0;                  // in PolygonalModel::facets
    FacetSide side = FacetSide::front;
    Vec3d center{0, 0, 0}, normal{0, 0, 1};  // the normal is unit and points away from this side
    double area = 0;                         // m^2

    std::span<const Vec3d> polygon() const { return {corners.data(), corner_count}; }
};

/// The patches of one side of one facet: rows of equal pieces. Those of a triangle are n rows of triangles.
struct PatchGrid {
    std::uint32_t first;          // the number of its first patch
    std::uint32_t columns, rows;  // of a triangle both are n
    bool exists = false;          // whether the scene shows this side
};

/// The surfaces of a scene, cut into patches. What is not shown (one side of a one-sided shape) has none.
struct PatchMesh {
    PolygonalModel model;
    std::vector<Patch> patches = {};
    std::vector<Vec3d> vertices = {};                  // corners that patches share where no edge parts them
    std::vector<std::array<PatchGrid, 2>> grids = {};  // of each facet: front, back
    std::vector<std::vector<std::uint32_t>> facets_of_occluder = {};

    const Material& material(const Patch& patch) const;
    const Object& object(const Patch& patch) const { return model.scene.objects[occluder(patch)]; }
    std::uint32_t occluder(const Patch& patch) const { return model.facets[patch.facet].occluder; }
};

struct MeshOptions {
    double edge;  // metres: patches are cut until no side of a piece is longer
};

/// Cuts a scene into patches whose sides are at most options.edge long. It throws an Error where that makes more than
/// `most` patches.
PatchMesh patch_mesh(const Scene& scene, const MeshOptions& options, std::size_t most = 1'000'000);

/// The same with one patch for each side of a flat piece; pieces of curved surfaces are at most `edge` long.
PatchMesh pieces_of(const Scene& scene, double edge);

/// The edge at which a scene has about this many patches: as many as possible, but no more, or the coarsest there is.
double edge_for_patches(const Scene& scene, std::size_t patches);

/// The patch of an occluder's side that a point of it lies in; the nearest one of a point that rounding has put beside
/// all.
struct PatchPlace {
    std::uint32_t patch;
    std::array<double, 4> weights;  // of the patch's corners, for interpolation; they sum to 1
};
PatchPlace patch_at(const PatchMesh& mesh, std::uint32_t occluder, FacetSide side, const Vec3d& point);

}  // namespace raylab
