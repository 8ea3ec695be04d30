#pragma once

#include "raylab/geometry/vector.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace raylab {

enum class FacetSide : std::uint8_t { front, back };

/// A piece of one side of a surface, taken to be equally bright everywhere.
struct Patch {
    std::array<Vec3d, 4> corners{};           // the first `corner_count` of them; counter-clockwise seen from its side
    std::array<std::uint32_t, 4> vertices{};  // of each corner, in PatchMesh::vertices
    std::uint32_t corner_count = 0;           // 3 or 4
    std::uint32_t facet = 0;                  // in PolygonalModel::facets
    FacetSide side = FacetSide::front;
    std::uint8_t level = 0;                  // how often a cell of the facet's grid was quartered for it
    Vec3d center{0, 0, 0}, normal{0, 0, 1};  // the normal is unit and points away from this side
    double area = 0;                         // m^2

    std::span<const Vec3d> polygon() const { return {corners.data(), corner_count}; }
};

/// The patch of a convex polygon on a side of a facet, without vertices; the corners are counter-clockwise as seen from
/// that side. Absent for a polygon without area.
std::optional<Patch> patch_of(std::span<const Vec3d> corners, std::uint32_t facet, FacetSide side);

/// Four patches that make up one: each corner's by the middles of the two sides there, in the corners' order. A
/// quadrilateral's fourth corner of each is its middle; of a triangle the fourth patch is what remains in the middle.
std::array<Patch, 4> quarters(const Patch& patch);

/// The quarter in which a place of a patch lies. Weights are those of the corners.
struct QuarterPlace {
    std::uint32_t quarter;
    std::array<double, 4> weights;
};
QuarterPlace quarter_at(std::uint32_t corner_count, const std::array<double, 4>& weights);

/// The longest side, metres.
double longest_side(const Patch& patch);

}  // namespace raylab
