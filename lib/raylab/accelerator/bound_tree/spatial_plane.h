#pragma once

#include "raylab/accelerator/bound_tree/box_split.h"
#include "raylab/accelerator/split_tree/cell_part.h"

#include <optional>
#include <span>

namespace raylab {

/// The plane, of 15 across each axis, that the surface area heuristic expects the least work of when what reaches through it
/// is cut in two; those left out that go through more than `most_cut` parts. Absent: none is left.
std::optional<BoxSplit> cheapest_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts, std::size_t most_cut);

}  // namespace raylab
