#pragma once

#include "raylab/report/plane/plane_drawing.h"

// The lesson's drawings, in its order.

namespace raylab::volumes {

/// Cauchy's formula: a patch and its shadow, and a convex body whose shadow is covered twice.
PlaneDrawing draw_cauchy();

/// Shadows of a unit cube from several sides, and their mean.
PlaneDrawing draw_shadows_of_cube();

/// The ball's box as slabs, from above, and two rays with their spans of t: one hits the box, one misses it.
PlaneDrawing draw_slabs();

}  // namespace raylab::volumes
