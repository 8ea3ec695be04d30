#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab {

/// A ray past a sphere with its nearest point, and below it the quadratic over the same t, with its two roots.
PlaneDrawing draw_ray_and_sphere();

/// Height and distance from the axis of a point, and the profiles of the surfaces of revolution.
PlaneDrawing draw_revolution();

}  // namespace raylab
