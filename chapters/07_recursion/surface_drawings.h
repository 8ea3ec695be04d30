#pragma once

#include "raylab/report/plane/plane_drawing.h"

// Drawings of what happens where a ray meets a surface.

namespace raylab::recursion {

/// A hit with the ray that found it and the three kinds of rays that leave it: to the light, mirrored, transmitted.
PlaneDrawing draw_hit();

/// The vectors of README (3) to (5) in the unit circle about a hit: D, N, R, and the parts A and T.
PlaneDrawing draw_snell_vectors();

/// Rays that leave water upward, each split by Snell and Fresnel; the outermost have total internal reflection.
PlaneDrawing draw_snell();

/// A facet with an interpolated normal by which the mirrored ray would go into the facet.
PlaneDrawing draw_mirrored_into_facet();

}  // namespace raylab::recursion
