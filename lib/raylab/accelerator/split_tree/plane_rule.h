#pragma once

#include "raylab/accelerator/split_tree/cell_part.h"
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

// Rules for splitting a cell of a kd-tree or an axis-aligned BSP tree.

namespace raylab {

/// A splitting plane. Parts that lie in the plane itself belong to one side.
struct SplitPlane {
    std::size_t axis;
    float at;
    enum class InPlane { below, above } in_plane = InPlane::below;
};

/// Absent: the cell is a leaf.
using PlaneRule = std::function<std::optional<SplitPlane>(const Box& cell, std::span<const CellPart> parts)>;

/// The cell's longest side is halved until a cell has at most `leaf` parts, or a plane would cut most of them.
PlaneRule spatial_median(std::size_t leaf = 2);

/// The longest side is split so that as many centers of parts lie below as above; leaves are as for spatial_median().
PlaneRule object_median(std::size_t leaf = 2);

/// The costs of a node's visit and of a primitive test, and the share of the tests that a split which leaves one side
/// empty saves: of the values tried, the fastest for the bunny (chapter 12).
struct SahCosts {
    double visit = 3, test = 1, empty_bonus = 0.1;
};

/// The plane with the lowest cost by the surface area heuristic, if that is lower than the cost of testing all parts.
/// (MacDonald and Booth, Heuristics for Ray Tracing Using Space Subdivision, The Visual Computer 6, 1990; the sweep
/// over sorted events: Wald and Havran, On Building Fast kd-Trees for Ray Tracing, and on Doing That in O(N log N),
/// 2006.)
PlaneRule surface_area_heuristic(const SahCosts& costs = {});

/// The same with another estimate in the place of sah_cost().
using CutCost = std::function<double(const SahCut&)>;
PlaneRule surface_area_heuristic(const SahCosts& costs, const CutCost& cost);

}  // namespace raylab
