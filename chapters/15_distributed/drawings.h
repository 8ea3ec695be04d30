#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <cstdint>

namespace raylab::spread {

/// 64 points of every sampler, one panel each.
PlaneDrawing draw_patterns(std::uint64_t seed);

/// Rays from the points of a lens meet in the plane in focus, and make a disk of any other.
PlaneDrawing draw_thin_lens();

}  // namespace raylab::spread
