#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab::transforms {

/// One ray in two spaces: on the left the world with a sheared disk, on the right the space in which the disk is round.
/// The marks on the ray are at the same t in both.
PlaneDrawing draw_two_spaces();

/// A circle that is stretched and pressed, with a tangent, and its normal carried in two ways.
PlaneDrawing draw_normal_scale();

/// The same hit and the same light in both spaces, with the angle between the normal and the light.
PlaneDrawing draw_shade_in_world();

}  // namespace raylab::transforms
