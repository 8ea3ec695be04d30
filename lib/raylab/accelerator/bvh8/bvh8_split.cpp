#include "raylab/accelerator/bvh8/bvh8_split.h"

#include <algorithm>
#include <array>

namespace raylab::bvh8_parts {

namespace {

// The boxes and counts of the primitives in the bins of each axis.
class Bins {
public:
    explicit Bins(int count) : count_(count) {
        for (auto& axis : bins_) std::fill_n(axis.begin(), count, Bin{});
    }

    void add(const Reference& one, FourInts bin) {
        for (int axis = 0; axis < 3; ++axis) {
            Bin& into = bins_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin[axis])];
            into.box.add(one.box());
            ++into.count;
        }
    }

    // Replaces `best` by the split with the lowest cost between two bins of an axis, if that is lower.
    void try_axis(int axis, Split& best) const {
        const auto& bins = bins_[static_cast<std::size_t>(axis)];
        std::array<float, max_bins> right_work;  // of the bins from here on
        Bin right;
        for (int i = count_; i-- > 1;) {
            right.add(bins[static_cast<std::size_t>(i)]);
            right_work[static_cast<std::size_t>(i)] = right.count == 0 ? infinity : right.work();
        }
        Bin left;
        for (int i = 1; i < count_; ++i) {
            left.add(bins[static_cast<std::size_t>(i) - 1]);
            if (left.count == 0) continue;
            const float cost = left.work() + right_work[static_cast<std::size_t>(i)];
            if (cost < best.cost) best = {axis, i, cost};
        }
    }

private:
    int count_;
    std::array<std::array<Bin, max_bins>, 3> bins_;
};

// From this depth on parts are halved, so that the depth is bounded.
constexpr int halving_depth = Bvh8Nodes::max_depth - 30;

}  // namespace

bool References::fit_in_leaf(const ReferenceRange& part) const {
    if (part.size() == 1) return true;
    if (part.size() > bvh8_width) return false;
    const std::span<const Reference> found = of(part);
    return found.back().is_triangle() && std::ranges::all_of(found, &Reference::is_triangle);
}

std::pair<ReferenceRange, ReferenceRange> References::split(const ReferenceRange& part, int depth) {
    const Binning binning(part);
    const Split best = depth < halving_depth ? best_split(part, binning) : Split{};
    if (best.cost < infinity)
        return partition(part, [&](const Reference& one) { return binning.of(one)[best.axis] < best.bin; });
    return halves(part);
}

Split References::best_split(const ReferenceRange& part, const Binning& binning) const {
    Bins bins(binning.count);
    for (const Reference& one : of(part)) bins.add(one, binning.of(one));
    Split best;
    for (int axis = 0; axis < 3; ++axis)
        if (binning.scale[axis] > 0) bins.try_axis(axis, best);
    return best;
}

template <class Left>
std::pair<ReferenceRange, ReferenceRange> References::partition(const ReferenceRange& part, const Left& goes_left) {
    ReferenceRange left, right;
    std::size_t i = part.begin, end = part.end;
    while (i < end) {
        const Reference one = all_[i];
        if (goes_left(one)) {
            left.add(one);
            ++i;
        } else {
            right.add(one);
            all_[i] = all_[--end];
            all_[end] = one;
        }
    }
    left.begin = part.begin;
    left.end = right.begin = i;
    right.end = part.end;
    return {left, right};
}

std::pair<ReferenceRange, ReferenceRange> References::halves(const ReferenceRange& part) const {
    const std::size_t middle = part.begin + part.size() / 2;
    return {part_of(part.begin, middle), part_of(middle, part.end)};
}

ReferenceRange References::part_of(std::size_t begin, std::size_t end) const {
    ReferenceRange part{begin, end};
    for (std::size_t i = begin; i < end; ++i) part.add(all_[i]);
    return part;
}

}  // namespace raylab::bvh8_parts
