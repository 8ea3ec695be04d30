#pragma once

#include "raylab/geometry/bounds/box.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace raylab {

/// Where a set of boxes is split in two: by the coordinate of their centers.
struct BoxSplit {
    int axis;
    double place;  // the boxes whose center lies below it go left
    double cost;   // of both parts, in primitive tests, times the surface area of the box that encloses both
};

/// The rule that chooses the place of the split.
enum class SplitRule {
    median,  // as many boxes on either side, along the axis on which the centers spread most
    binned,  // the lowest cost by the surface area heuristic, over 16 bins for each axis (Wald, On fast Construction of
             // SAH-based Bounding Volume Hierarchies, RT 2007)
    sweep,   // the lowest cost, over every place (MacDonald and Booth, Heuristics for ray tracing using space
             // subdivision, 1990)
};

/// Finds splits of boxes by one rule.
class BoxSplitter {
public:
    BoxSplitter(std::span<const Box> boxes, SplitRule rule);

    double center(std::uint32_t box, int axis) const { return centers_[box][axis]; }

    /// The best split of some of the boxes; absent where all their centers are the same.
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
