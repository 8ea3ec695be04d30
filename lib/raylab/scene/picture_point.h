#pragma once

#include "raylab/image/draw.h"
#include "raylab/scene/camera.h"

#include <optional>

namespace raylab {

/// The pixel coordinates at which a point of space appears in the picture: the inverse of picture_ray(). They may lie
/// outside the picture; absent where the point lies behind the eye or beside it.
std::optional<Point2> picture_point(const CameraFrame& frame, const Vec3d& point);

}  // namespace raylab
