#include "raylab/accelerator/bvh8/bvh8_plane_split.h"

#include "raylab/accelerator/split_tree/cell_part.h"
#include "raylab/accelerator/split_tree/clipped_bounds.h"

#include <algorithm>

namespace raylab::bvh8_parts {

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

// What a triangle has in each bin from the first to the last in which its box lies.
class ChoppedTriangle {
public:
    ChoppedTriangle(const Triangle& triangle, const Extent& box, const PlaneBinning& binning, int first, int last)
        : box_(box), first_(first), last_(last) {
        const Extent nothing;
        std::fill_n(min_.begin() + first, last - first + 1, nothing.min);
        std::fill_n(max_.begin() + first, last - first + 1, nothing.max);
        borders_[place(first)] = box.min[binning.axis];
        for (int bin = first + 1; bin <= last; ++bin) borders_[place(bin)] = binning.border(bin);
        borders_[place(last + 1)] = box.max[binning.axis];
        add_edge(triangle.a, triangle.b, binning.axis);
        add_edge(triangle.b, triangle.c, binning.axis);
        add_edge(triangle.c, triangle.a, binning.axis);
    }

    Extent at(int bin) const { return {larger(min_[place(bin)], box_.min), smaller(max_[place(bin)], box_.max)}; }

private:
    // Adds to each bin what an edge has between the bin's borders.
    void add_edge(const Vec3f& one, const Vec3f& other, int axis) {
        const bool rises = one[axis] <= other[axis];
        const Vec3f &low = rises ? one : other, &high = rises ? other : one;
        const float from = low[axis], to = high[axis], inverse = 1 / (to - from);
        const FourFloats start = four(low), end = four(high), along = end - start;
        for (int bin = first_; bin <= last_; ++bin) {
            const float below = borders_[place(bin)], above = borders_[place(bin + 1)];
            if (from > above) continue;
            if (to < below) break;
            add(bin, from >= below ? start : start + along * ((below - from) * inverse));
            add(bin, to <= above ? end : start + along * ((above - from) * inverse));
        }
    }
    void add(int bin, FourFloats point) {
        min_[place(bin)] = smaller(min_[place(bin)], point);
        max_[place(bin)] = larger(max_[place(bin)], point);
    }

    Extent box_;
    int first_, last_;
    // Only those of the bins in between are set.
    std::array<float, PlaneBinning::most + 1> borders_;
    std::array<FourFloats, PlaneBinning::most> min_, max_;
};

Box as_box(const Extent& extent) {
    return {{extent.min[0], extent.min[1], extent.min[2]}, {extent.max[0], extent.max[1], extent.max[2]}};
}
Extent as_extent(const Box& box) {
    return {FourFloats{box.min.x, box.min.y, box.min.z, 0}, FourFloats{box.max.x, box.max.y, box.max.z, 0}};
}

bool has_points(const Extent& box) {
    return box.min[0] <= box.max[0] && box.min[1] <= box.max[1] && box.min[2] <= box.max[2];
}

}  // namespace

PlaneBinning::PlaneBinning(const Extent& box, std::size_t size)
    : count(std::min(most, 4 + static_cast<int>(size / 16))), scale(0) {
    const FourFloats length = box.max - box.min;
    axis = length[0] >= length[1] && length[0] >= length[2] ? 0 : length[1] >= length[2] ? 1 : 2;
    low = box.min[axis];
    width = length[axis] / static_cast<float>(count);
    if (border(1) > low && border(count - 1) < box.max[axis])
        scale = std::min(1 / width, std::numeric_limits<float>::max());
}

void PlaneBins::add(const Reference& one, const std::optional<Triangle>& triangle, const PlaneBinning& binning) {
    const Extent box = one.box();
    const int axis = binning.axis, first = binning.bin_of(box.min[axis]), last = binning.bin_of(box.max[axis]);
    ++begun_[place(first)];
    ++ended_[place(last)];
    if (first == last) {
        boxes_[place(first)].add(box);
    } else if (triangle) {
        const ChoppedTriangle chopped(*triangle, box, binning, first, last);
        for (int bin = first; bin <= last; ++bin)
            if (const Extent part = chopped.at(bin); has_points(part)) boxes_[place(bin)].add(part);
    } else {
        for (int bin = first; bin <= last; ++bin) {
            Extent part = box;
            if (bin > first) part.min[axis] = binning.border(bin);
            if (bin < last) part.max[axis] = binning.border(bin + 1);
            boxes_[place(bin)].add(part);
        }
    }
}

void PlaneBins::add(const PlaneBins& other) {
    for (std::size_t bin = 0; bin < PlaneBinning::most; ++bin) {
        boxes_[bin].add(other.boxes_[bin]);
        begun_[bin] += other.begun_[bin];
        ended_[bin] += other.ended_[bin];
    }
}

PlaneSplit PlaneBins::best(const PlaneBinning& binning, std::size_t size, std::size_t most_cut) const {
    std::array<Bin, PlaneBinning::most> right;  // of the bins from here on
    Bin sum;
    for (int bin = binning.count; bin-- > 1;) {
        sum.add({boxes_[place(bin)], ended_[place(bin)]});
        right[place(bin)] = sum;
    }
    PlaneSplit best;
    Bin left;
    for (int bin = 1; bin < binning.count; ++bin) {
        left.add({boxes_[place(bin - 1)], begun_[place(bin - 1)]});
        const Bin& rest = right[place(bin)];
        const std::size_t cut = left.count + rest.count - size;
        if (cut > most_cut || left.count >= size || rest.count >= size) continue;
        if (const float cost = left.work() + rest.work(); cost < best.cost) best = {bin, cost};
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
