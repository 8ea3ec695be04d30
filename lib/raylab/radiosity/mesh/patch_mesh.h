#pragma once

#include "raylab/radiosity/mesh/patch.h"
#include "raylab/radiosity/mesh/polygonal_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// The cells of one side of one facet: rows of equal pieces. Those of a triangle are n rows of triangles.
struct PatchGrid {
    std::uint32_t first;          // the number of its first cell
    std::uint32_t columns, rows;  // of a triangle both are n
    bool exists = false;          // whether the scene shows this side
};

/// A cell of a grid is a patch, or it is quartered: quarters() are four cells more.
struct PatchCell {
    enum class Kind : std::uint8_t { patch, quartered } kind;
    std::uint32_t number;  // of the patch, or of the first of the four cells
};

/// A vertex in the middle of the side of a patch that is larger than its neighbours (a T-vertex).
struct HangingVertex {
    std::uint32_t vertex;
    std::array<std::uint32_t, 2> ends;  // of the side, or of the half of it of which this is the middle
};

/// The surfaces of a scene, cut into patches. What is not shown (one side of a one-sided shape) has none.
struct PatchMesh {
    PolygonalModel model;
    std::vector<Patch> patches = {};
    std::vector<Vec3d> vertices = {};                  // corners that patches share where no edge parts them
    std::vector<std::array<PatchGrid, 2>> grids = {};  // of each facet: front, back
    std::vector<PatchCell> cells = {};                 // of all grids, and of quartered cells
    std::vector<HangingVertex> hanging = {};           // a vertex comes after the ends of its side
    std::vector<std::vector<std::uint32_t>> facets_of_occluder = {};

    const Material& material(const Patch& patch) const;
    const Object& object(const Patch& patch) const { return model.scene.objects[occluder(patch)]; }
    std::uint32_t occluder(const Patch& patch) const { return model.facets[patch.facet].occluder; }
    /// Whether that side of an occluder has patches; the other side of a one-sided shape has none.
    bool has_patches(std::uint32_t occluder, FacetSide side) const;
    /// The side of an occluder that looks into a direction.
    FacetSide side_towards(std::uint32_t occluder, const Vec3d& direction) const;
};

/// Along which lines surfaces are cut before they become patches.
enum class MeshLines {
    none,
    contact,  // where another surface stands on one: with_contact_lines()
};

struct MeshOptions {
    double edge;  // metres: patches are cut until no side of a piece is longer
    MeshLines lines = MeshLines::none;
};

/// Cuts a scene into patches whose sides are at most options.edge long. It throws an Error where that makes more than
/// `most` patches.
PatchMesh patch_mesh(const Scene& scene, const MeshOptions& options, std::size_t most = 1'000'000);

/// The same with one patch for each side of a flat piece; pieces of curved surfaces are at most options.edge long.
PatchMesh pieces_of(const Scene& scene, const MeshOptions& options);

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
