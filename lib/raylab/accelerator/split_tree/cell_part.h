#pragma once

#include "raylab/geometry/bounds/box.h"

#include <cstdint>

namespace raylab {

struct SortedPrimitives;

/// The bounded part of one primitive that lies inside a cell.
struct CellPart {
    Box box;
    std::uint32_t index;  // which of the bounded primitives
};

/// The bounds of a part below a plane and above it: every point of the primitive in the part's box is in one of the
/// two. Either may be empty.
struct CutPart {
    Box below, above;
};

/// Cuts a box at a plane.
CutPart cut_box(const Box& box, int axis, float at);

/// Cuts a part at a plane: a triangle that is not transformed is clipped, for anything else its box is cut.
CutPart cut_part(const SortedPrimitives& sorted, const CellPart& part, int axis, float at);

}  // namespace raylab
