#include "raylab/accelerator/bvh/box_split.h"

#include "raylab/accelerator/bvh/cheapest_cut.h"

#include <algorithm>
#include <array>
#include <limits>

namespace raylab {

namespace {

constexpr int bin_count = 16;

// A box may reach to infinity. A finite center suffices, because it only guides the splitting.
Vec3d finite_center(const Box& box) {
    constexpr float largest = std::numeric_limits<float>::max();
    return Box{glm::max(box.min, Vec3f(-largest)), glm::min(box.max, Vec3f(largest))}.center();
}

}  // namespace

BoxSplitter::BoxSplitter(std::span<const Box> boxes, SplitRule rule) : boxes_(boxes), rule_(rule) {
    centers_.reserve(boxes.size());
    for (const Box& box : boxes) centers_.push_back(finite_center(box));
}

std::optional<BoxSplit> BoxSplitter::split(std::span<const std::uint32_t> boxes) const {
    if (rule_ == SplitRule::median) return median(boxes);
    std::optional<BoxSplit> best;
    for (int axis = 0; axis < 3; ++axis) {
        const auto found = rule_ == SplitRule::binned ? binned(boxes, axis) : sweep(boxes, axis);
        if (found && (!best || found->cost < best->cost)) best = found;
    }
    return best;
}

std::optional<BoxSplit> BoxSplitter::binned(std::span<const std::uint32_t> boxes, int axis) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t i : boxes) {
        low = std::min(low, center(i, axis));
        high = std::max(high, center(i, axis));
    }
    const double width = (high - low) / bin_count;
    if (!(width > 0)) return std::nullopt;
    std::array<CutSide, bin_count> bins;
    for (const std::uint32_t i : boxes) {
        const int bin = static_cast<int>((center(i, axis) - low) / width);
        bins[static_cast<std::size_t>(std::clamp(bin, 0, bin_count - 1))].add({boxes_[i], 1});
    }
    std::array<double, bin_count> above_work;
    return cheapest_cut({bins, bins}, above_work, axis,
                        [&](std::size_t i) { return std::optional(low + static_cast<double>(i) * width); });
}

std::optional<BoxSplit> BoxSplitter::sweep(std::span<const std::uint32_t> boxes, int axis) const {
    std::vector<std::uint32_t> sorted(boxes.begin(), boxes.end());
    std::ranges::sort(sorted, {}, [&](std::uint32_t i) { return std::pair(center(i, axis), i); });
    std::vector<CutSide> pieces;
    pieces.reserve(sorted.size());
    for (const std::uint32_t i : sorted) pieces.push_back({boxes_[i], 1});
    std::vector<double> above_work(pieces.size());
    return cheapest_cut({pieces, pieces}, above_work, axis, [&](std::size_t i) {
        const double place = center(sorted[i], axis);
        return center(sorted[i - 1], axis) < place ? std::optional(place) : std::nullopt;
    });
}

std::optional<BoxSplit> BoxSplitter::median(std::span<const std::uint32_t> boxes) const {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::uint32_t i : boxes) {
        low = glm::min(low, centers_[i]);
        high = glm::max(high, centers_[i]);
    }
    const Vec3d spread = high - low;
    const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    if (!(spread[axis] > 0)) return std::nullopt;
    std::vector<double> along;
    for (const std::uint32_t i : boxes) along.push_back(center(i, axis));
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::ranges::nth_element(along, middle);
    return BoxSplit{axis, *middle, 0};
}

}  // namespace raylab
