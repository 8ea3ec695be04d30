#include "raylab/accelerator/wide/wide_build.h"

#include "raylab/accelerator/wide/wide_leaf_writer.h"
#include "raylab/accelerator/wide/wide_parts.h"
#include "raylab/base/error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace raylab {

namespace {

using namespace wide_parts;

class Builder {
public:
    Builder(std::span<const Triangle> triangles, std::span<const Box> others) : triangles_(triangles) {
        if (triangles.size() + others.size() > WideChild::most_primitives)
            throw Error("expected at most 134 217 728 primitives, found " + std::to_string(triangles.size() + others.size()));
        references_.reserve(triangles.size() + others.size());
        Extent all;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Four a = four(triangles[i].a), b = four(triangles[i].b), c = four(triangles[i].c);
            references_.push_back({lower(lower(a, b), c), upper(upper(a, b), c), i, Kind::triangle});
            all.add(lower(lower(a, b), c));
            all.add(upper(upper(a, b), c));
        }
        for (int axis = 0; axis < 3; ++axis)
            if (all.min[axis] < -WideNodes::farthest || all.max[axis] > WideNodes::farthest) tree_.is_far = true;
        tree_.least_corner = std::bit_cast<std::array<float, 4>>(all.min);
        tree_.largest_corner = std::bit_cast<std::array<float, 4>>(all.max);
        for (std::size_t i = 0; i < others.size(); ++i) references_.push_back({four(others[i].min), four(others[i].max), i, Kind::other});
    }

    WideNodes build() {
        if (references_.empty()) return {};
        Part all{.end = references_.size()};
        for (const Reference& one : references_) all.add(one);
        tree_.leaves.reserve(2 * triangles_.size());  // as many lines: more are never needed, and memory is used where it is written
        tree_.others.reserve(references_.size() - triangles_.size());
        tree_.nodes.reserve(references_.size() / 12 + 1);
        grow(all, 1);
        tree_.nodes.shrink_to_fit();
        tree_.leaves.shrink_to_fit();
        if (tree_.leaves.size() > WideChild::most_lines)
            throw Error("expected leaves of at most 8 GiB, found " + std::to_string(sizeof(WideLine) * tree_.leaves.size()) + " bytes");
        return std::move(tree_);
    }

private:
    std::size_t grow(const Part& part, int depth) {
        std::array<Part, wide> parts{part};
        const std::size_t count = divide(parts, depth);
        const std::size_t index = tree_.nodes.size();
        for (std::size_t i = 0; i < count; ++i)
            if (parts[i].size() <= wide) prefetch(parts[i]);
        tree_.nodes.emplace_back();
        for (std::size_t i = 0; i < count; ++i) set_box(tree_.nodes[index], i, parts[i].box);
        for (std::size_t i = 0; i < count; ++i) {
            const WideChild child = is_leaf(parts[i]) ? leaf(parts[i]) : WideChild::node(grow(parts[i], depth + 1));
            tree_.nodes[index].children[i] = child;
        }
        return index;
    }

    // The triangles lie scattered, as they were given: memory is asked for a node's all at once.
    void prefetch(const Part& part) const {
        for (std::size_t i = part.begin; i < part.end; ++i)
            if (references_[i].is_triangle()) __builtin_prefetch(&triangles_[references_[i].number()]);
    }

    static void set_box(WideNode& node, std::size_t place, const Extent& box) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            node.planes[row][place] = box.min[axis] < -WideNodes::largest ? -infinity : box.min[axis];
            node.planes[row + 3][place] = box.max[axis] > WideNodes::largest ? infinity : box.max[axis];
        }
    }

    // Splits the largest part that is no leaf until there are eight, or leaves only. Returns how many there are.
    std::size_t divide(std::array<Part, wide>& parts, int depth) {
        std::size_t count = 1;
        while (count < wide) {
            Part* largest = nullptr;
            for (std::size_t i = 0; i < count; ++i)
                if (!is_leaf(parts[i]) && (!largest || parts[i].box.half_area() > largest->box.half_area())) largest = &parts[i];
            if (!largest) break;
            const auto [left, right] = split(*largest, depth);
            *largest = left;
            parts[count++] = right;
        }
        return count;
    }

    bool is_leaf(const Part& part) const {
        if (part.size() == 1) return true;
        return part.size() <= wide && references_[part.begin].is_triangle() && references_[part.end - 1].is_triangle() &&
               std::all_of(at(part.begin), at(part.end), [](const Reference& one) { return one.is_triangle(); });
    }

    std::vector<Reference>::const_iterator at(std::size_t i) const { return references_.begin() + static_cast<std::ptrdiff_t>(i); }

    std::pair<Part, Part> split(const Part& part, int depth) {
        const Binning binning(part);
        const Split best = depth < halving_depth ? best_split(part, binning) : Split{};
        if (best.cost < infinity) return partition(part, [&](const Reference& one) { return binning.of(one)[best.axis] < best.bin; });
        return halves(part);
    }

    // From this depth on parts are halved, so that the depth is bounded.
    static constexpr int halving_depth = WideNodes::max_depth - 30;

    std::pair<Part, Part> halves(const Part& part) const {
        const std::size_t middle = part.begin + part.size() / 2;
        return {part_of(part.begin, middle), part_of(middle, part.end)};
    }

    Part part_of(std::size_t begin, std::size_t end) const {
        Part part{begin, end};
        for (std::size_t i = begin; i < end; ++i) part.add(references_[i]);
        return part;
    }

    template <class Left>
    std::pair<Part, Part> partition(const Part& part, const Left& goes_left) {
        Part left, right;
        std::size_t i = part.begin, end = part.end;
        while (i < end) {
            const Reference one = references_[i];
            if (goes_left(one)) {
                left.add(one);
                ++i;
            } else {
                right.add(one);
                references_[i] = references_[--end];
                references_[end] = one;
            }
        }
        left.begin = part.begin;
        left.end = right.begin = i;
        right.end = part.end;
        return {left, right};
    }

    Split best_split(const Part& part, const Binning& binning) const {
        std::array<std::array<Bin, most_bins>, 3> bins;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int bin = 0; bin < binning.count; ++bin) bins[axis][static_cast<std::size_t>(bin)] = {};
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const Reference& one = references_[i];
            const FourInts bin = binning.of(one);
            for (int axis = 0; axis < 3; ++axis) {
                Bin& into = bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin[axis])];
                into.box.add(one.box());
                ++into.count;
            }
        }
        Split best;
        for (int axis = 0; axis < 3; ++axis)
            if (binning.scale[axis] > 0) try_axis(bins[static_cast<std::size_t>(axis)], binning.count, axis, best);
        return best;
    }

    static void try_axis(const std::array<Bin, most_bins>& bins, int count, int axis, Split& best) {
        std::array<float, most_bins> right_work;  // of the bins from here on
        Bin right;
        const auto add = [](Bin& to, const Bin& bin) {
            to.box.add(bin.box);
            to.count += bin.count;
        };
        for (int i = count; i-- > 1;) {
            add(right, bins[static_cast<std::size_t>(i)]);
            right_work[static_cast<std::size_t>(i)] = right.count == 0 ? infinity : work(right.box.half_area(), right.count);
        }
        Bin left;
        for (int i = 1; i < count; ++i) {
            add(left, bins[static_cast<std::size_t>(i) - 1]);
            if (left.count == 0) continue;
            const float cost = work(left.box.half_area(), left.count) + right_work[static_cast<std::size_t>(i)];
            if (cost < best.cost) best = {axis, i, cost};
        }
    }

    WideChild leaf(const Part& part) {
        const std::size_t count = part.size();
        if (!references_[part.begin].is_triangle()) {
            tree_.others.push_back(references_[part.begin].number());
            return WideChild::leaf(WideChild::Kind::others, tree_.others.size() - 1, 1);
        }
        tree_.triangle_count += count;
        WideLeafWriter writer;
        for (std::size_t i = part.begin; i < part.end; ++i) writer.add(triangles_[references_[i].number()], references_[i].number());
        return WideChild::leaf(WideChild::Kind::triangles, writer.append_to(tree_.leaves), count);
    }

    std::span<const Triangle> triangles_;
    std::vector<Reference> references_;
    WideNodes tree_;
};

}  // namespace

WideNodes build_wide_nodes(std::span<const Triangle> triangles, std::span<const Box> others) {
    return Builder(triangles, others).build();
}

}  // namespace raylab
