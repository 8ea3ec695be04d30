#include "raylab/accelerator/octree_cells.h"

#include <numeric>

namespace raylab {

namespace {

// A cell to be: its lowest lattice cell, 2^size of them a side, and which boxes touch it.
struct Plot {
    LatticeCell lowest;
    int size;
    std::span<const std::uint32_t> boxes;
};

// A plot cut into a block, and what touches each of its cells.
struct Block {
    LatticeCell lowest;
    int bits, size;  // 2^bits cells a side, each 2^size lattice cells
    std::vector<std::uint32_t> first, boxes;  // where each cell's boxes begin, and one past the last

    std::uint32_t cells() const { return 1u << (3 * bits); }
    Plot plot(std::uint32_t cell) const {
        const auto inside = std::span(boxes).subspan(first[cell], first[cell + 1] - first[cell]);
        return {lowest_in_block(lowest, cell, size, bits), size, inside};
    }
};

class Builder {
public:
    Builder(std::span<const LatticeRange> ranges, const OctreeLimits& limits)
        : ranges_(ranges), limits_(limits), smallest_(Lattice::bits - std::min(limits.depth, Lattice::bits)) {}

    OctreeCells build() {
        std::vector<std::uint32_t> everything(ranges_.size());
        std::iota(everything.begin(), everything.end(), 0u);
        constexpr std::size_t first_block = 8;
        tree_.cells.resize(first_block);
        const OctreeCell root = settle({{0, 0, 0}, Lattice::bits, everything});
        std::fill_n(tree_.cells.begin(), first_block, root);
        tree_.cells.shrink_to_fit();
        tree_.references.shrink_to_fit();
        return std::move(tree_);
    }

private:
    OctreeCell settle(const Plot& plot) {
        if (plot.boxes.size() <= limits_.few || plot.size <= smallest_) return leaf(plot);
        const bool in_seads = plot.boxes.size() <= limits_.seads.most;
        const Block block = cut(plot, in_seads ? std::min(limits_.seads.bits, plot.size - smallest_) : 1);
        if (limits_.cut == OctreeLimits::Cut::where_it_pays && !pays(plot, block)) return leaf(plot);
        const auto first = static_cast<std::uint32_t>(tree_.cells.size());
        tree_.cells.resize(first + block.cells());
        for (std::uint32_t i = 0; i < block.cells(); ++i) {
            const OctreeCell cell = in_seads ? leaf(block.plot(i)) : settle(block.plot(i));
            tree_.cells[first + i] = cell;
        }
        return {first, OctreeCell::divided + static_cast<std::uint32_t>(block.bits)};
    }

    OctreeCell leaf(const Plot& plot) {
        const auto first = static_cast<std::uint32_t>(tree_.references.size());
        tree_.references.insert(tree_.references.end(), plot.boxes.begin(), plot.boxes.end());
        return {first, static_cast<std::uint32_t>(plot.boxes.size())};
    }

    // A ray through a cube meets a given cube in it with the ratio of their surfaces.
    static bool pays(const Plot& plot, const Block& block) {
        return block.boxes.size() < plot.boxes.size() << (2 * block.bits);
    }

    Block cut(const Plot& plot, int bits) const {
        Block block{plot.lowest, bits, plot.size - bits, {}, {}};
        block.first.assign(block.cells() + 1, 0);
        for (const std::uint32_t box : plot.boxes) for_each_cell(block, box, [&](std::uint32_t cell) { ++block.first[cell + 1]; });
        std::partial_sum(block.first.begin(), block.first.end(), block.first.begin());
        block.boxes.resize(block.first.back());
        std::vector<std::uint32_t> next(block.first.begin(), block.first.end() - 1);
        for (const std::uint32_t box : plot.boxes)
            for_each_cell(block, box, [&](std::uint32_t cell) { block.boxes[next[cell]++] = box; });
        return block;
    }

    // The cells of a block that a box touches, one of those that touch the whole of it.
    template <class Do>
    void for_each_cell(const Block& block, std::uint32_t box, const Do& act) const {
        const LatticeRange& range = ranges_[box];
        const std::int32_t last_cell = (1 << block.bits) - 1;
        LatticeCell from{}, to{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            from[axis] = std::max(range.first[axis] - block.lowest[axis], 0) >> block.size;
            to[axis] = std::min((range.last[axis] - block.lowest[axis]) >> block.size, last_cell);
        }
        for (std::int32_t z = from[2]; z <= to[2]; ++z)
            for (std::int32_t y = from[1]; y <= to[1]; ++y)
                for (std::int32_t x = from[0]; x <= to[0]; ++x)
                    act(static_cast<std::uint32_t>(x | y << block.bits | z << (2 * block.bits)));
    }

    std::span<const LatticeRange> ranges_;
    OctreeLimits limits_;
    int smallest_;  // size of a cell at the greatest depth
    OctreeCells tree_;
};

}  // namespace

OctreeCells build_octree(std::span<const LatticeRange> ranges, const OctreeLimits& limits) {
    return Builder(ranges, limits).build();
}

}  // namespace raylab
