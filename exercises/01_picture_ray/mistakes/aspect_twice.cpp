// hint: aspect_twice
// The picture's shape is in half_width already.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double aspect = double(frame.image.width) / frame.image.height;
    const double px = (2 * x / frame.image.width - 1) * aspect * frame.half_width;
    const double py = (1 - 2 * y / frame.image.height) * frame.half_height;
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d off = px * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
