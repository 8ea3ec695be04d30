#pragma once

#include "raylab/accelerator/bvh8/bvh8_parts.h"
#include "raylab/geometry/shapes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

// Splits of primitives by planes (M. Stich, H. Friedrich, A. Dietrich, Spatial Splits in Bounding Volume Hierarchies,
// HPG 2009): a primitive that a plane cuts is named on both sides, each time with a smaller box.

namespace raylab::bvh8_parts {

/// Equally spaced planes across each axis of a part.
struct PlaneBinning {
    static constexpr int most = 16;
    int count;  // of bins
    FourFloats low, width, scale;

    PlaneBinning(const Extent& box, std::size_t size);

    bool is_wide(int axis) const { return scale[axis] > 0; }
    FourInts bins_of(FourFloats point) const;
    float border(int axis, int bin) const { return low[axis] + static_cast<float>(bin) * width[axis]; }
};

/// A plane between two bins of an axis.
struct PlaneSplit {
    int axis = 0, bin = 0;
    float cost = infinity;
};

/// The bounds of the primitives that begin in each bin of each axis, and of those that end there: before a plane lie
/// those that begin before it, cut off at it. What is left of a cut primitive is bounded by its box here. (Bounds of
/// what the triangle has in each bin would cost twice the time to build, and rays visit as many nodes; the boxes of the
/// chosen plane's sides are those of the cut triangles.)
class PlaneBins {
public:
    explicit PlaneBins(int count = 0);

    void add(const Reference& one, const PlaneBinning& binning);
    void add(const PlaneBins& other);

    /// The plane of the lowest cost, of those that cut no more than `most_cut` of `size` primitives.
    PlaneSplit best(const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const;

private:
    struct OfBin {
        Bin begun, ended;
    };
    using OfAxis = std::array<OfBin, PlaneBinning::most>;
    PlaneSplit best_across(int axis, const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const;

    int count_;
    std::array<OfAxis, 3> bins_;  // only the first `count_` are set
};

/// The two parts of a primitive on either side of a plane. Every point of it in its box is in the box of one of the
/// two; a side that has none of them is empty (clipped_bounds.cpp has the bound of the rounding).
std::pair<Extent, Extent> cut_by_plane(const Reference& one, const std::optional<Triangle>& triangle, int axis,
                                       float at);

inline bool is_empty(const Extent& box) { return box.min[0] > box.max[0]; }

}  // namespace raylab::bvh8_parts
