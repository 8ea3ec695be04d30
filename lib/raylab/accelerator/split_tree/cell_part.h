#pragma once

#include "raylab/geometry/box.h"

#include <cstdint>

namespace raylab {

struct SortedPrimitives;

/// What lies inside a cell of one primitive, bounded.
struct CellPart {
    Box box;
    std::uint32_t index;  // which of the bounded primitives
};

/// What of a part lies below a plane and above it, bounded: whatever of the primitive is in the part's box is in one of the
/// two. Either may be empty.
struct CutPart {
    Box below, above;
};

/// The same of all that is in a box.
CutPart cut_box(const Box& box, int axis, float at);

/// A triangle that rests where it was made is clipped, of anything else the box is.
CutPart cut_part(const SortedPrimitives& sorted, const CellPart& part, int axis, float at);

}  // namespace raylab
