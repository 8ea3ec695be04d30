#pragma once

#include "raylab/report/plane/plane_drawing.h"

// Drawings of shadow rays.

namespace raylab::shadows {

/// Two lights over a floor with a ball: a point that both reach, one that one reaches, one that none does.
PlaneDrawing draw_shadow_rays();

/// Where shadow acne comes from: computed hit points lie above and below their surface.
PlaneDrawing draw_acne();

/// A shadow ray's start under the microscope: the floats about a hit point, and where each way puts the start.
PlaneDrawing draw_starts();

/// A facet with interpolated normals where the light stands behind the facet, but in front of a normal.
PlaneDrawing draw_terminator();

}  // namespace raylab::shadows
