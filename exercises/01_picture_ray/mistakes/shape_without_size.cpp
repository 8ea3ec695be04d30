// hint: half_sizes_missing
// The picture has its shape, and a half height of 1.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const double px = 2 * x / frame.image.width - 1, py = 1 - 2 * y / frame.image.height;
    const double aspect = static_cast<double>(frame.image.width) / frame.image.height;
    const Vec3d off = px * aspect * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
