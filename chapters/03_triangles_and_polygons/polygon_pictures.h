#pragma once

#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <cstddef>

namespace raylab {

/// A tilted star in a corner of the room, and its three projections to the walls: the one along the dominant axis is
/// the largest.
Image projection_picture(ImageSize size, int threads);

/// How the even-odd rule counts: the star seen along its dominant axis, with points and the edges that their half-lines
/// cross.
Image crossings_picture(ImageSize size);

/// The methods that decide which rays hit the star.
enum class StarMethod { even_odd, half_planes, fan };
Image star_picture(StarMethod method, ImageSize size, int threads);

}  // namespace raylab
