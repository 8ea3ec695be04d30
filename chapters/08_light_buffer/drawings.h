#pragma once

#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

// The lesson's drawings, in its order.

namespace raylab::lantern {

/// The room, the cube about the light, and one cell with the pyramid of directions behind it.
PlaneDrawing draw_cube(const Scene& scene);

/// How a direction finds its column: by similar triangles.
PlaneDrawing draw_column(const Scene& scene);

/// The same cell from above, with the depths at which its list's primitives begin.
PlaneDrawing draw_list(const Scene& scene);

/// A plane through the light that has a triangle on one side and a cell on the other.
PlaneDrawing draw_separating_plane();

/// A wall behind the light, which no side of the cell keeps out, but the fifth plane does.
PlaneDrawing draw_fifth_plane();

}  // namespace raylab::lantern
