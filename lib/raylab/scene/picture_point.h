#pragma once

#include "raylab/image/draw.h"
#include "raylab/scene/camera.h"

#include <optional>

namespace raylab {

/// Where a point of space appears in the picture, in pixels: the way back of picture_ray(). It may lie outside the
/// picture; absent where it lies behind the eye or beside it.
std::optional<Point2> picture_point(const CameraFrame& frame, const Vec3d& point);

}  // namespace raylab
