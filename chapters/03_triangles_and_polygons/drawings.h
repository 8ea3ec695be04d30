#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab {

/// A triangle as a ray sees it: the signs of its three edges all around, and the areas of the parts inside.
PlaneDrawing draw_edge_signs();

/// How the even-odd rule counts: a star with points, and the edges that their half-lines cross.
PlaneDrawing draw_crossings();

/// Half-lines through a vertex, and which edges they cross by the half-open rule.
PlaneDrawing draw_half_open();

}  // namespace raylab
