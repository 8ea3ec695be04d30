#include "raylab/accelerator/octree/octree_hash_table.h"

#include <cassert>

namespace raylab {

CellNames::CellNames(const OctreeCells& tree) {
    const std::size_t slots = std::bit_ceil(tree.cells.size() / 8 * 2);  // at most half of them taken
    parents_.assign(slots, none);
    cells_.resize(8 * slots);
    shift_ = 64 - static_cast<int>(std::bit_width(slots - 1));
    name_below(0, 0, tree);
}

// The cells from `first` on; the root alone has a place in the first block, for no name but 1 is asked for there.
void CellNames::name_below(std::uint64_t parent, std::uint32_t first, const OctreeCells& tree) {
    const std::size_t at = slot(parent);
    parents_[at] = parent;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const OctreeCell& cell = cells_[8 * at + i] = tree.cells[first + i];
        if (!cell.is_divided() || (parent == 0 && i != 1)) continue;
        assert(cell.block_bits() == 1);
        name_below(parent << 3 | i, cell.first, tree);
    }
}

}  // namespace raylab
