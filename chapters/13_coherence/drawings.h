#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab::coherence {

/// A packet of rays and three boxes: one that all rays hit, one that some do, one that none does.
PlaneDrawing draw_packet();

/// A ray as a point on a square about its origin, and a cell of ray space: origins, directions, and what they may hit.
PlaneDrawing draw_ray_cells();

}  // namespace raylab::coherence
