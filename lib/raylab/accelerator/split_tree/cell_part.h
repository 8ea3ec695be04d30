#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shapes.h"

#include <cstdint>
#include <optional>

namespace raylab {

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

/// Cuts the part of a triangle, which is clipped, or of anything else (absent), whose box is cut.
CutPart cut_part(const CellPart& part, const std::optional<Triangle>& triangle, int axis, float at);

}  // namespace raylab
