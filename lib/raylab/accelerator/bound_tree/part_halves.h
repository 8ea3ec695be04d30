#pragma once

#include "raylab/accelerator/split_tree/cell_part.h"

#include <optional>
#include <span>
#include <vector>

namespace raylab {

/// Parts on either side of a cut.
struct PartHalves {
    std::vector<CellPart> below, above;
};

Box box_about(std::span<const CellPart> parts);

/// A cut, and what it is expected to cost: of both sides, in primitive tests, times the surface area of the box about both.
struct PartCut {
    PartHalves halves;
    double cost;
};

/// The cheapest cut between the boxes' centers, each part on one side; absent: their centers are all the same.
std::optional<PartCut> cut_between_centers(std::span<const CellPart> parts);

/// The cheapest plane, where it costs less than `most_cost`. What reaches through it is put on both sides, unless one side
/// alone, with a larger box, is cheaper ("reference unsplitting"); at most `most_cut` parts are. Absent: there is none.
std::optional<PartCut> cut_by_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts, double most_cost,
                                    std::size_t most_cut);

/// As they come: half of them on either side.
PartHalves cut_in_the_middle(std::span<const CellPart> parts);

}  // namespace raylab
