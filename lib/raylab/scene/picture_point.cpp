#include "raylab/scene/picture_point.h"

namespace raylab {

std::optional<Point2> picture_point(const CameraFrame& frame, const Vec3d& point) {
    const Vec3d seen = point - frame.eye;
    const double depth = dot(seen, frame.forward);
    if (!(depth > 0)) return std::nullopt;
    const double distance = frame.projection == CameraFrame::Projection::perspective ? depth : 1;
    const double across = dot(seen, frame.right) / (frame.half_width * distance);
    const double upward = dot(seen, frame.up) / (frame.half_height * distance);
    return Point2{(across + 1) / 2 * frame.image.width, (1 - upward) / 2 * frame.image.height};
}

}  // namespace raylab
