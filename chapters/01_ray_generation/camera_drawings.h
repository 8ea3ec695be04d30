#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <cstdint>

// Drawings of a camera's numbers and of the points of its pixels.

namespace raylab::ray_generation {

/// The eye C, the picture at distance d with its edges l, r, b and t, and the ray of one pixel.
PlaneDrawing draw_camera_numbers();

/// The points of 6 x 4 pixels: ours, and those of the formula that puts the outer ones on the edges.
PlaneDrawing draw_pixel_points();

/// Nine pixels with their samples, by four patterns.
PlaneDrawing draw_sample_patterns(std::uint64_t seed);

}  // namespace raylab::ray_generation
