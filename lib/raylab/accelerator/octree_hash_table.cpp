#include "raylab/accelerator/octree_hash_table.h"

#include <cassert>

namespace raylab {

CellNames::CellNames(const OctreeCells& tree) {
    const std::size_t slots = std::bit_ceil(2 * tree.cells.size());  // at most half of them taken
    slots_.resize(slots);
    shift_ = 64 - static_cast<int>(std::bit_width(slots - 1));
    name_below(1, tree.cells[0], tree);
}

void CellNames::name_below(std::uint64_t name, const OctreeCell& cell, const OctreeCells& tree) {
    slots_[slot(name)] = {name, cell};
    if (!cell.is_divided()) return;
    assert(cell.block_bits() == 1);
    for (std::uint32_t i = 0; i < 8; ++i) name_below(name << 3 | i, tree.cells[cell.first + i], tree);
}

}  // namespace raylab
