#pragma once

#include "raylab/report/plane/plane_drawing.h"

// Drawings of light at a surface.

namespace raylab::lighting {

/// The ways that light can take where it meets matter: mirrored, scattered, transmitted, scattered through, absorbed.
PlaneDrawing draw_light_meets_matter();

/// The direction to a point light from three points of a floor, and to a distant one.
PlaneDrawing draw_point_and_distant();

/// A beam of light on a surface, straight and slanted: the slanted one is spread over more of it.
PlaneDrawing draw_lambert();

/// N, L, V and R at a point, and how R is made of L.
PlaneDrawing draw_vectors();

/// Phong's lobe, cos^n of the angle to R as a length in each direction, for three n.
PlaneDrawing draw_lobes();

/// An edge of a triangle with its corners' normals: Gouraud mixes colours along it, Phong mixes normals.
PlaneDrawing draw_interpolation();

}  // namespace raylab::lighting
