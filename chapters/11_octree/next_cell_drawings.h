#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab::octrees {

/// A ray through a square that is cut in four and in four again, and the tree of its cells: one step up to the smallest
/// cell that holds the old place and the new one, and down to the next leaf.
PlaneDrawing draw_up_and_down();

/// The same ray through blocks of 2 x 2 and of 4 x 4 cells: each step changes one number by one, or leaves the block.
PlaneDrawing draw_blocks();

}  // namespace raylab::octrees
