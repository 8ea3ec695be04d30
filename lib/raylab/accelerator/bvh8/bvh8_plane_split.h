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

/// Equally spaced planes across the longest axis of a part. (Planes across all three cost twice the time to build, and
/// save 1 to 5 % of the nodes that rays visit.)
struct PlaneBinning {
    static constexpr int most = 16;
    int axis, count;  // of bins
    float low, width, scale;

    PlaneBinning(const Extent& box, std::size_t size);

    bool is_wide() const { return scale > 0; }
    int bin_of(float at) const { return std::clamp(static_cast<int>((at - low) * scale), 0, count - 1); }
    float border(int bin) const { return low + static_cast<float>(bin) * width; }
};

/// A plane between two bins.
struct PlaneSplit {
    int bin = 0;
    float cost = infinity;
};

/// The bounds of what primitives have in each bin, and how many begin and end there.
class PlaneBins {
public:
    /// Bounds of a triangle's parts ignore rounding, because they only guide the choice of the plane.
    void add(const Reference& one, const std::optional<Triangle>& triangle, const PlaneBinning& binning);
    void add(const PlaneBins& other);

    /// The plane of the lowest cost, of those that cut no more than `most_cut` of `size` primitives.
    PlaneSplit best(const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const;

private:
    template <class T>
    using OfBins = std::array<T, PlaneBinning::most>;

    OfBins<Extent> boxes_;
    OfBins<std::uint32_t> begun_{}, ended_{};
};

/// The two parts of a primitive on either side of a plane. Every point of it in its box is in the box of one of the
/// two; a side that has none of them is empty (clipped_bounds.cpp has the bound of the rounding).
std::pair<Extent, Extent> cut_by_plane(const Reference& one, const std::optional<Triangle>& triangle, int axis,
                                       float at);

inline bool is_empty(const Extent& box) { return box.min[0] > box.max[0]; }

}  // namespace raylab::bvh8_parts
