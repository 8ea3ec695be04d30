#pragma once

#include "raylab/accelerator/split_tree/cell_part.h"

#include <optional>
#include <span>
#include <vector>

namespace raylab {

struct SortedPrimitives;

/// The parts on either side of a cut.
struct PartHalves {
    std::vector<CellPart> below, above;
};

Box box_about(std::span<const CellPart> parts);

/// A cut and its expected cost: of both sides, in primitive tests, times the surface area of the box that encloses
/// both.
struct PartCut {
    PartHalves halves;
    double cost;
};

/// The cheapest cut between the centers of the boxes, with each part on one side; absent where all centers are the
/// same.
std::optional<PartCut> cut_between_centers(std::span<const CellPart> parts);

/// The cheapest plane, if it costs less than `max_cost`. A part that the plane cuts is put on both sides, unless
/// putting it on one side alone, with a larger box, is cheaper ("reference unsplitting"); at most `most_cut` parts are
/// cut. Absent if there is no such plane.
std::optional<PartCut> cut_by_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts, double max_cost,
                                    std::size_t most_cut);

/// The first half of the parts, in their order, and the second half.
PartHalves cut_in_the_middle(std::span<const CellPart> parts);

}  // namespace raylab
