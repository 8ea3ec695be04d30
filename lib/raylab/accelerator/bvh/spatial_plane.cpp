#include "raylab/accelerator/bvh/spatial_plane.h"

#include "raylab/accelerator/bvh/cheapest_cut.h"
#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/accelerator/split_tree/clipped_bounds.h"
#include "raylab/accelerator/split_tree/finite_cell.h"
#include "raylab/number/scalar.h"

#include <algorithm>
#include <array>

namespace raylab {

namespace {

constexpr std::size_t plane_count = 16;  // as many as box_split uses for centers

void grow(Box& box, const Vec3f& point) { box = unite(box, {point, point}); }

// Bounds the part of a triangle in a box on either side of a plane. It ignores rounding, because it only guides the
// choice of the plane.
CutPart roughly_cut(const Triangle& triangle, const Box& box, int axis, float at) {
    CutPart cut;
    const std::array<Vec3f, 3> corners{triangle.a, triangle.b, triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f &p = corners[i], &q = corners[(i + 1) % 3];
        if (p[axis] <= at) grow(cut.below, p);
        if (p[axis] >= at) grow(cut.above, p);
        if ((p[axis] < at) == (q[axis] < at)) continue;
        Vec3f crossing = p + (q - p) * ((at - p[axis]) / (q[axis] - p[axis]));
        crossing[axis] = at;
        grow(cut.below, crossing);
        grow(cut.above, crossing);
    }
    return {intersection(cut.below, box), intersection(cut.above, box)};
}

// A cell between equally spaced planes, with the bounds of what each part has in each bin.
class SpatialBins {
public:
    SpatialBins(const SortedPrimitives& sorted, const Box& cell, int axis)
        : sorted_(&sorted), axis_(axis), low_(cell.min[axis]), width_((double{cell.max[axis]} - low_) / plane_count) {}

    bool are_wide() const { return border(1) > border(0) && border(plane_count) > border(plane_count - 1); }

    // A part adds its work once: below the cut where it begins, above the cut where it ends.
    void add(const CellPart& part) {
        const std::size_t first = bin(part.box.min[axis_]), last = bin(part.box.max[axis_]);
        ++below_[first].count;
        ++above_[last].count;
        const auto triangle = first < last ? sorted_->all.triangle(sorted_->bounded[part.index]) : std::nullopt;
        Box rest = part.box;
        for (std::size_t i = first; i < last; ++i) {
            const float at = border(i + 1);
            const CutPart cut = triangle ? roughly_cut(*triangle, rest, axis_, at) : cut_box(rest, axis_, at);
            below_[i].box = unite(below_[i].box, cut.below);
            rest = cut.above;
        }
        below_[last].box = unite(below_[last].box, rest);
    }

    std::optional<BoxSplit> cheapest(std::size_t parts, std::size_t most_cut) {
        std::array<std::size_t, plane_count> cut{};  // how many parts the plane before each bin cuts
        std::size_t begun = 0, ended = 0;
        for (std::size_t i = 0; i < plane_count; ++i) {
            above_[i].box = below_[i].box;
            cut[i] = begun - ended;
            begun += below_[i].count;
            ended += above_[i].count;
        }
        std::array<double, plane_count> above_work;
        return cheapest_cut({below_, above_}, above_work, axis_, [&](std::size_t i) {
            return cut[i] <= most_cut && cut[i] < parts ? std::optional<double>(border(i)) : std::nullopt;
        });
    }

private:
    float border(std::size_t i) const { return cast<float>(low_ + static_cast<double>(i) * width_); }
    std::size_t bin(float x) const {
        return static_cast<std::size_t>(std::clamp((x - low_) / width_, 0.0, plane_count - 1.0));
    }

    const SortedPrimitives* sorted_;
    int axis_;
    double low_, width_;
    std::array<CutSide, plane_count> below_, above_;
};

}  // namespace

std::optional<BoxSplit> cheapest_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts,
                                       std::size_t most_cut) {
    Box cell;
    for (const CellPart& part : parts) cell = unite(cell, part.box);
    std::optional<BoxSplit> best;
    for (int axis = 0; axis < 3; ++axis) {
        SpatialBins bins(sorted, finite(cell), axis);
        if (!bins.are_wide()) continue;
        for (const CellPart& part : parts) bins.add(part);
        const auto found = bins.cheapest(parts.size(), most_cut);
        if (found && (!best || found->cost < best->cost)) best = found;
    }
    return best;
}

}  // namespace raylab
