// hint: half_sizes_missing
// The picture reaches from -1 to 1, whatever it is said to.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const double px = 2 * x / frame.image.width - 1, py = 1 - 2 * y / frame.image.height;
    const Vec3d off = px * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
