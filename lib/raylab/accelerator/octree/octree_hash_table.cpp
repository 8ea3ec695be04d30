#include "raylab/accelerator/octree/octree_hash_table.h"

#include <cassert>

namespace raylab {

CellNames::CellNames(const OctreeCells& tree) {
    const std::size_t slots = std::bit_ceil(tree.cells.size() / 8 * 2);  // at most half of the slots are taken
    parents_.assign(slots, none);
    cells_.resize(8 * slots);
    shift_ = 64 - static_cast<int>(std::bit_width(slots - 1));
    name_below(0, 0, tree);
}

// Enters the cells of a block, which begins at `first`. Of the first block only the root is entered, under the name 1,
// because no other name is looked up there.
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
