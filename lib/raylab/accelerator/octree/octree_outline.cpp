#include "raylab/accelerator/octree/octree_outline.h"

#include <utility>

namespace raylab {

namespace {

class Drawing {
public:
    Drawing(const Lattice& lattice, const OctreeCells& tree, std::span<const std::uint32_t> places)
        : lattice_(lattice), tree_(tree), places_(places) {}

    Outline draw() {
        add(tree_.cells[0], {0, 0, 0}, Lattice::bits);
        return std::move(outline_);
    }

private:
    std::uint32_t add(const OctreeCell& cell, const LatticeCell& lowest, int size) {
        const auto number = static_cast<std::uint32_t>(outline_.nodes.size());
        outline_.nodes.push_back({.bound = lattice_.box(lowest, size)});
        if (!cell.is_divided()) {
            for (const std::uint32_t i : tree_.in(cell)) outline_.nodes[number].primitives.push_back(places_[i]);
            return number;
        }
        const int bits = cell.block_bits();
        for (std::uint32_t place = 0; place < 1u << (3 * bits); ++place) {
            const LatticeCell in = lowest_in_block(lowest, place, size - bits, bits);
            const std::uint32_t child = add(tree_.cells[cell.first + place], in, size - bits);
            outline_.nodes[number].children.push_back(child);
        }
        return number;
    }

    const Lattice& lattice_;
    const OctreeCells& tree_;
    std::span<const std::uint32_t> places_;
    Outline outline_;
};

}  // namespace

Outline outline_of(const Lattice& lattice, const OctreeCells& tree, std::span<const std::uint32_t> places) {
    return places.empty() ? Outline{} : Drawing(lattice, tree, places).draw();
}

}  // namespace raylab
