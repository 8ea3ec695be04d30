#include "raylab/accelerator/octree/octree_cells.h"

#include <numeric>
#include <optional>

namespace raylab {

namespace {

// A cell that is being built: its lowest lattice cell, its side of 2^size of them, and the shapes that touch it.
struct Plot {
    LatticeCell lowest;
    int size;
    std::span<const std::uint32_t> shapes;
    double budget;  // how many references the cells below it may have
};

// A plot cut into a block, with the shapes that touch each of its cells.
struct Block {
    LatticeCell lowest;
    int bits, size;                            // 2^bits cells along each side, each 2^size lattice cells wide
    std::vector<std::uint32_t> first, shapes;  // where each cell's shapes begin, and one past the last
    double budget;                             // how many references each of these shapes may become

    std::uint32_t cells() const { return 1u << (3 * bits); }
    Plot plot(std::uint32_t cell) const {
        const auto inside = std::span(shapes).subspan(first[cell], first[cell + 1] - first[cell]);
        return {lowest_in_block(lowest, cell, size, bits), size, inside, budget * static_cast<double>(inside.size())};
    }
};

class Builder {
public:
    Builder(std::span<const LatticeShape> shapes, const OctreeLimits& limits)
        : shapes_(shapes), limits_(limits), smallest_(Lattice::bits - std::min(limits.depth, Lattice::bits)) {}

    /// Absent where there would be too many cells and references.
    std::optional<OctreeCells> build() {
        std::vector<std::uint32_t> everything(shapes_.size());
        std::iota(everything.begin(), everything.end(), 0u);
        constexpr std::size_t first_block = 8;
        tree_.cells.resize(first_block);
        const OctreeCell root =
            build_cell({{0, 0, 0}, Lattice::bits, everything, static_cast<double>(everything.size()) * limits_.budget});
        if (is_too_large()) return std::nullopt;
        std::fill_n(tree_.cells.begin(), first_block, root);
        tree_.cells.shrink_to_fit();
        tree_.references.shrink_to_fit();
        return std::move(tree_);
    }

private:
    bool is_too_large() const {
        constexpr std::size_t at_least = std::size_t{1} << 22, for_each_shape = 128;
        return tree_.cells.size() + tree_.references.size() > at_least + for_each_shape * shapes_.size();
    }

    OctreeCell build_cell(const Plot& plot) {
        if (is_too_large()) return {};
        if (plot.shapes.size() <= limits_.few || plot.size <= smallest_) return leaf(plot);
        const bool in_seads = plot.shapes.size() <= limits_.seads.largest;
        const Block block = cut(plot, in_seads ? std::min(limits_.seads.bits, plot.size - smallest_) : 1);
        if (limits_.cut == OctreeLimits::Cut::where_it_pays && !pays(plot, block)) return leaf(plot);
        const auto first = static_cast<std::uint32_t>(tree_.cells.size());
        tree_.cells.resize(first + block.cells());
        for (std::uint32_t i = 0; i < block.cells(); ++i) {
            const OctreeCell cell = in_seads ? leaf(block.plot(i)) : build_cell(block.plot(i));
            tree_.cells[first + i] = cell;
        }
        return {first, OctreeCell::divided + static_cast<std::uint32_t>(block.bits)};
    }

    OctreeCell leaf(const Plot& plot) {
        const auto first = static_cast<std::uint32_t>(tree_.references.size());
        tree_.references.insert(tree_.references.end(), plot.shapes.begin(), plot.shapes.end());
        return {first, static_cast<std::uint32_t>(plot.shapes.size())};
    }

    // A ray through a cube hits a given cube inside it with a probability that is the ratio of their surface areas.
    static bool pays(const Plot& plot, const Block& block) {
        return block.shapes.size() < plot.shapes.size() << (2 * block.bits) && block.budget >= 1;
    }

    Block cut(const Plot& plot, int bits) const {
        Block block{plot.lowest, bits, plot.size - bits, {}, {}, 0};
        struct Found {
            std::uint32_t cell, shape;
        };
        std::vector<Found> found;
        for (const std::uint32_t shape : plot.shapes)
            for_each_cell(block, shape, [&](std::uint32_t cell) { found.push_back({cell, shape}); });
        block.first.assign(block.cells() + 1, 0);
        for (const Found& f : found) ++block.first[f.cell + 1];
        std::partial_sum(block.first.begin(), block.first.end(), block.first.begin());
        block.shapes.resize(found.size());
        block.budget = plot.budget / static_cast<double>(found.size());
        std::vector<std::uint32_t> next(block.first.begin(), block.first.end() - 1);
        for (const Found& f : found) block.shapes[next[f.cell]++] = f.shape;
        return block;
    }

    // The cells of a block that a shape touches; the shape touches the plot that was cut.
    template <class Do>
    void for_each_cell(const Block& block, std::uint32_t number, const Do& act) const {
        const LatticeShape& shape = shapes_[number];
        const std::int32_t last_cell = (1 << block.bits) - 1;
        LatticeCell from{}, to{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            from[axis] = std::max(shape.range.first[axis] - block.lowest[axis], 0) >> block.size;
            to[axis] = std::min((shape.range.last[axis] - block.lowest[axis]) >> block.size, last_cell);
        }
        const bool in_one = from == to;
        for (std::int32_t z = from[2]; z <= to[2]; ++z)
            for (std::int32_t y = from[1]; y <= to[1]; ++y)
                for (std::int32_t x = from[0]; x <= to[0]; ++x) {
                    const auto place = static_cast<std::uint32_t>(x | y << block.bits | z << (2 * block.bits));
                    if (in_one ||
                        !shape.misses(lowest_in_block(block.lowest, place, block.size, block.bits), block.size))
                        act(place);
                }
    }

    std::span<const LatticeShape> shapes_;
    OctreeLimits limits_;
    int smallest_;  // size of a cell at the greatest depth
    OctreeCells tree_;
};

}  // namespace

OctreeCells build_octree(std::span<const LatticeShape> shapes, const OctreeLimits& limits) {
    OctreeLimits shallower = limits;
    while (true) {
        if (auto tree = Builder(shapes, shallower).build()) return std::move(*tree);
        --shallower.depth;  // this ends, because a single leaf is never too large
    }
}

}  // namespace raylab
