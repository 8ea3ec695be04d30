#pragma once

#include "raylab/geometry/vector.h"
#include "raylab/image/image.h"

namespace raylab {

/// A colour, linear RGB, as pictures store it.
inline Pixel to_pixel(const Vec3d& color) { return {cast<float>(color.x), cast<float>(color.y), cast<float>(color.z)}; }

}  // namespace raylab
