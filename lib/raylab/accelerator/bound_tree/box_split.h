#pragma once

#include "raylab/geometry/box.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace raylab {

/// Where a set of boxes is cut in two: by the coordinate of their centers.
struct BoxSplit {
    int axis;
    double place;  // the boxes whose center lies below go left
    double cost;   // of both parts, in primitive tests, times the surface area of the box about both
};

/// How a place for the cut is chosen.
enum class SplitRule {
    median,  // as many boxes on either side, along the axis on which their centers are spread most
    binned,  // the least cost by the surface area heuristic, over 16 bins an axis (Wald, On fast Construction of SAH-based
             // Bounding Volume Hierarchies, RT 2007)
    sweep,   // the least cost, over every place (MacDonald and Booth, Heuristics for ray tracing using space subdivision, 1990)
};

/// Boxes that are to be cut, by the rule.
class BoxSplitter {
public:
    BoxSplitter(std::span<const Box> boxes, SplitRule rule);

    double center(std::uint32_t box, int axis) const { return centers_[box][axis]; }

    /// The best cut through some of them; absent: their centers are all the same.
    std::optional<BoxSplit> split(std::span<const std::uint32_t> boxes) const;

private:
    std::optional<BoxSplit> binned(std::span<const std::uint32_t> boxes, int axis) const;
    std::optional<BoxSplit> sweep(std::span<const std::uint32_t> boxes, int axis) const;
    std::optional<BoxSplit> median(std::span<const std::uint32_t> boxes) const;

    std::span<const Box> boxes_;
    std::vector<Vec3d> centers_;
    SplitRule rule_;
};

}  // namespace raylab
