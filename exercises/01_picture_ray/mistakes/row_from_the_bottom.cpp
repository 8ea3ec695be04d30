// hint: row_from_the_bottom
// Turns y round as the number of a row.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const double from_bottom = frame.image.height - 1 - y;
    const double px = 2 * x / frame.image.width - 1, py = 2 * from_bottom / frame.image.height - 1;
    const Vec3d off = px * frame.half_width * frame.right + py * frame.half_height * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
