#pragma once

#include "raylab/accelerator/split_tree/cell_part.h"
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

// Where a cell of a kd-tree or an axis-aligned BSP tree is cut in two, if it is.

namespace raylab {

/// Parts that lie in the plane itself belong to one side.
struct SplitPlane {
    std::size_t axis;
    float at;
    enum class InPlane { below, above } in_plane = InPlane::below;
};

/// Absent: the cell is a leaf.
using PlaneRule = std::function<std::optional<SplitPlane>(const Box& cell, std::span<const CellPart> parts)>;

/// The cell's longest side is halved until at most `leaf` parts are in it, or a cut would go through most of them.
PlaneRule spatial_median(std::size_t leaf = 2);

/// The longest side is cut so that as many parts' centers lie below as above; leaves likewise.
PlaneRule object_median(std::size_t leaf = 2);

/// What a visit of a node and a test of a primitive cost, and what share of the tests a cut saves that leaves one side
/// empty: of those tried, the fastest for the bunny (chapter 12).
struct SahCosts {
    double visit = 3, test = 1, empty_bonus = 0.1;
};

/// The plane that the surface area heuristic expects the least work of, if that is less than testing all.
/// (MacDonald and Booth, Heuristics for Ray Tracing Using Space Subdivision, The Visual Computer 6, 1990; the sweep
/// over sorted events: Wald and Havran, On Building Fast kd-Trees for Ray Tracing, and on Doing That in O(N log N),
/// 2006.)
PlaneRule surface_area_heuristic(const SahCosts& costs = {});

/// The same with an estimate of one's own in the place of sah_cost().
using CutCost = std::function<double(const SahCut&)>;
PlaneRule surface_area_heuristic(const SahCosts& costs, const CutCost& cost);

}  // namespace raylab
