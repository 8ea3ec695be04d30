// hint: middle_forgotten
// From -1/2 to 1/2.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const double px = x / frame.image.width - 0.5, py = 0.5 - y / frame.image.height;
    const Vec3d off = px * frame.half_width * frame.right + py * frame.half_height * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    const Vec3d dir = frame.forward + off;
    return {frame.eye, glm::normalize(dir), {0, inf}};
}
