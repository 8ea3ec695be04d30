#include "raylab/accelerator/bvh8/bvh8_plane_split.h"

#include "raylab/accelerator/split_tree/cell_part.h"
#include "raylab/accelerator/split_tree/clipped_bounds.h"

#include <algorithm>

namespace raylab::bvh8_parts {

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

Box as_box(const Extent& extent) {
    return {{extent.min[0], extent.min[1], extent.min[2]}, {extent.max[0], extent.max[1], extent.max[2]}};
}
Extent as_extent(const Box& box) {
    return {FourFloats{box.min.x, box.min.y, box.min.z, 0}, FourFloats{box.max.x, box.max.y, box.max.z, 0}};
}

}  // namespace

PlaneBinning::PlaneBinning(const Extent& box, std::size_t size)
    : count(std::min(most, 4 + static_cast<int>(size / 16))), low(box.min), scale{} {
    width = (box.max - box.min) / static_cast<float>(count);
    for (int axis = 0; axis < 3; ++axis)
        if (border(axis, 1) > low[axis] && border(axis, count - 1) < box.max[axis])
            scale[axis] = std::min(1 / width[axis], std::numeric_limits<float>::max());
}

FourInts PlaneBinning::bins_of(FourFloats point) const {
    const FourInts bin = __builtin_convertvector((point - low) * scale, FourInts), last = FourInts{} + (count - 1);
    return bin < 0 ? FourInts{} : bin > last ? last : bin;
}

PlaneBins::PlaneBins(int count) : count_(count) {
    for (OfAxis& axis : bins_) std::fill_n(axis.begin(), count_, OfBin{});
}

// (Unrolled like the loop of Bins: a tenth of a tree's time.)
void PlaneBins::add(const Reference& one, const PlaneBinning& binning) {
    const Bin alone{one.box(), 1};
    const FourInts first = binning.bins_of(alone.box.min), last = binning.bins_of(alone.box.max);
#pragma GCC unroll 3
    for (int axis = 0; axis < 3; ++axis) {
        bins_[place(axis)][place(first[axis])].begun.add(alone);
        bins_[place(axis)][place(last[axis])].ended.add(alone);
    }
}

void PlaneBins::add(const PlaneBins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t bin = 0; bin < place(count_); ++bin) {
            bins_[axis][bin].begun.add(other.bins_[axis][bin].begun);
            bins_[axis][bin].ended.add(other.bins_[axis][bin].ended);
        }
}

PlaneSplit PlaneBins::best(const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const {
    PlaneSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.is_wide(axis)) continue;
        const PlaneSplit one = best_across(axis, binning, size, most_cut);
        if (one.cost < best.cost) best = one;
    }
    return best;
}

PlaneSplit PlaneBins::best_across(int axis, const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const {
    const OfAxis& bins = bins_[place(axis)];
    std::array<Bin, PlaneBinning::most> after;  // each plane
    Bin sum;
    for (int bin = count_; bin-- > 1;) {
        sum.add(bins[place(bin)].ended);
        after[place(bin)] = sum;
    }
    PlaneSplit best;
    Bin before;
    for (int bin = 1; bin < count_; ++bin) {
        before.add(bins[place(bin - 1)].begun);
        const float at = binning.border(axis, bin);
        Bin left = before, right = after[place(bin)];
        const std::size_t cut = left.count + right.count - size;
        if (cut > most_cut || left.count >= size || right.count >= size) continue;
        left.box.max[axis] = std::min<float>(left.box.max[axis], at);
        right.box.min[axis] = std::max<float>(right.box.min[axis], at);
        if (const float cost = left.work() + right.work(); cost < best.cost) best = {axis, bin, cost};
    }
    return best;
}

std::pair<Extent, Extent> cut_by_plane(const Reference& one, const std::optional<Triangle>& triangle, int axis,
                                       float at) {
    const CutPart boxes = cut_box(as_box(one.box()), axis, at);
    if (!triangle) return {as_extent(boxes.below), as_extent(boxes.above)};
    return {as_extent(clipped_bounds(*triangle, boxes.below)), as_extent(clipped_bounds(*triangle, boxes.above))};
}

}  // namespace raylab::bvh8_parts
