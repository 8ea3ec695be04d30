#pragma once

#include "raylab/accelerator/bvh/box_split.h"
#include "raylab/accelerator/split_tree/cell_part.h"

#include <optional>
#include <span>

namespace raylab {

struct SortedPrimitives;

/// Of 15 planes across each axis, the one for which the surface area heuristic expects the lowest cost when the parts
/// that it cuts are put on both sides. Planes that cut more than `most_cut` parts are left out. Absent if none is left.
std::optional<BoxSplit> cheapest_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts,
                                       std::size_t most_cut);

}  // namespace raylab
