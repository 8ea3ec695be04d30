#pragma once

#include "raylab/report/plane/plane_drawing.h"

// A walk through a small grid in the plane, step by step: a plank in several cells, and a ball before it.

namespace raylab::grids {

/// The number of cells until the walk ends.
inline constexpr int walk_steps = 5;

/// The t at which the ray crosses the planes of x and of y, each equally spaced, and both in order.
PlaneDrawing draw_crossings();

/// The walk in its cell number `step`, from 1 on: the planes ahead, what is tested, and the nearest hit so far.
PlaneDrawing draw_walk_step(int step);

/// All cells that list the plank, and its hit, which lies beyond the cell in which it is found.
PlaneDrawing draw_hit_beyond();

}  // namespace raylab::grids
