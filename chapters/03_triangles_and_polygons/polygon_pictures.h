#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <cstddef>

namespace raylab {

/// A tilted star in a corner of the room, and its three projections to the walls: the one along the dominant axis is
/// the largest.
Image projection_picture(ImageSize size, int threads);

/// A star of five points in the plane z = 0.
Polygon flat_star();

/// The methods that decide which rays hit the star.
enum class StarMethod { even_odd, half_planes, fan };
Image star_picture(StarMethod method, ImageSize size, int threads);

}  // namespace raylab
