#include "raylab/accelerator/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace raylab {

namespace {

constexpr int bin_count = 16;
constexpr std::size_t largest_leaf = 8;
constexpr double visit_cost = 0.5;  // of a node, in primitive tests: both its boxes take about half as long as a triangle
// From this depth on nodes are halved, so that the depth is bounded: 2^32 boxes are halved in 32 steps.
constexpr int halving_depth = BoxTree::max_depth - 33;

struct Slice {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
};

struct Split {
    int axis;
    double place;  // the boxes whose center lies below go left
    double cost;   // in primitive tests, times the area of the box that is split
};

struct Bin {
    Box box;
    std::size_t count = 0;

    void add(const Bin& other) {
        box = unite(box, other.box);
        count += other.count;
    }
    double work() const { return count == 0 ? 0 : surface_area(box) * static_cast<double>(count); }
};

// One slice's centers along one axis, in bins of equal width.
struct Bins {
    int axis;
    double low, width;

    std::size_t of(const Vec3d& center) const {
        const auto bin = static_cast<int>((center[axis] - low) / width);
        return static_cast<std::size_t>(std::clamp(bin, 0, bin_count - 1));
    }
};

class Builder {
public:
    explicit Builder(std::span<const Box> boxes) : boxes_(boxes) {
        for (const Box& box : boxes) centers_.push_back(finite_center(box));
        tree_.order.resize(boxes.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0u);
    }

    BoxTree build() {
        if (boxes_.empty()) return {};
        tree_.nodes.reserve(boxes_.size());
        grow({0, boxes_.size()}, 1);
        tree_.nodes.shrink_to_fit();
        return std::move(tree_);
    }

private:
    // A box may reach to infinity; its center only guides the splitting.
    static Vec3d finite_center(const Box& box) {
        constexpr float largest = std::numeric_limits<float>::max();
        return Box{glm::max(box.min, Vec3f(-largest)), glm::min(box.max, Vec3f(largest))}.center();
    }

    std::uint32_t grow(Slice slice, int depth) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        const std::size_t middle = divide(slice, depth);
        set_child(index, 0, {slice.begin, middle}, depth);
        set_child(index, 1, {middle, slice.end}, depth);
        return index;
    }

    void set_child(std::uint32_t index, std::size_t side, Slice slice, int depth) {
        const Box box = box_of(slice);
        const bool leaf = slice.size() <= 1 || is_leaf(slice, box);
        const auto first = leaf ? static_cast<std::uint32_t>(slice.begin) : grow(slice, depth + 1);
        BoxTree::Node& node = tree_.nodes[index];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis][side] = box.min[static_cast<int>(axis)];
            node.planes[axis + 3][side] = box.max[static_cast<int>(axis)];
        }
        node.first[side] = first;
        node.count[side] = leaf ? static_cast<std::uint32_t>(slice.size()) : 0;
    }

    Box box_of(Slice slice) const {
        Box box;
        for (std::size_t i = slice.begin; i < slice.end; ++i) box = unite(box, boxes_[tree_.order[i]]);
        return box;
    }

    bool is_leaf(Slice slice, const Box& box) const {
        if (slice.size() > largest_leaf) return false;
        const auto split = best_split(slice);
        const double area = surface_area(box);
        return !split || static_cast<double>(slice.size()) * area <= visit_cost * area + split->cost;
    }

    // Sorts the slice into two parts and tells where the second begins. Neither is empty where there are two boxes.
    std::size_t divide(Slice slice, int depth) {
        if (slice.size() < 2) return slice.end;
        const auto split = depth < halving_depth ? best_split(slice) : std::nullopt;
        const auto at = [&](std::size_t i) { return tree_.order.begin() + static_cast<std::ptrdiff_t>(i); };
        if (!split) return slice.begin + slice.size() / 2;
        const auto middle = std::partition(at(slice.begin), at(slice.end), [&](std::uint32_t i) {
            return centers_[i][split->axis] < split->place;
        });
        const auto found = static_cast<std::size_t>(middle - tree_.order.begin());
        return found == slice.begin || found == slice.end ? slice.begin + slice.size() / 2 : found;
    }

    std::optional<Split> best_split(Slice slice) const {
        std::optional<Split> best;
        for (int axis = 0; axis < 3; ++axis) {
            const auto split = best_split(slice, axis);
            if (split && (!best || split->cost < best->cost)) best = split;
        }
        return best;
    }

    std::optional<Split> best_split(Slice slice, int axis) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = slice.begin; i < slice.end; ++i) {
            const double center = centers_[tree_.order[i]][axis];
            low = std::min(low, center);
            high = std::max(high, center);
        }
        const Bins bins{axis, low, (high - low) / bin_count};
        if (!(bins.width > 0)) return std::nullopt;

        std::array<Bin, bin_count> filled;
        for (std::size_t i = slice.begin; i < slice.end; ++i) {
            const std::uint32_t box = tree_.order[i];
            filled[bins.of(centers_[box])].add({boxes_[box], 1});
        }
        return cheapest(filled, bins);
    }

    static std::optional<Split> cheapest(const std::array<Bin, bin_count>& bins, const Bins& layout) {
        std::array<double, bin_count> right_work;  // of the bins from here on
        Bin right;
        for (std::size_t i = bin_count; i-- > 1;) {
            right.add(bins[i]);
            right_work[i] = right.work();
        }
        std::optional<Split> best;
        Bin left;
        for (std::size_t i = 1; i < bin_count; ++i) {
            left.add(bins[i - 1]);
            const double cost = left.work() + right_work[i];
            if (!best || cost < best->cost) best = {layout.axis, layout.low + static_cast<double>(i) * layout.width, cost};
        }
        return best;
    }

    std::span<const Box> boxes_;
    std::vector<Vec3d> centers_;
    BoxTree tree_;
};

}  // namespace

BoxTree build_box_tree(std::span<const Box> boxes) { return Builder(boxes).build(); }

}  // namespace raylab
