#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    // Maps pixels, with y down, to the picture rectangle: -1 to 1 from its left and bottom edge to its right and top
    // edge.
    const double across = 2 * x / frame.image.width - 1;
    const double upward = 1 - 2 * y / frame.image.height;
    const Vec3d aside = frame.right * (across * frame.half_width) + frame.up * (upward * frame.half_height);

    const Interval<double> range{0, std::numeric_limits<double>::infinity()};
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + aside, frame.forward, range};
    return {frame.eye, glm::normalize(frame.forward + aside), range};
}
