// hint: whole_numbers
// The middle of an odd picture is half a pixel off: ints are halved.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const int middle_x = frame.image.width / 2, middle_y = frame.image.height / 2;
    const double px = (x - middle_x) / frame.image.width * 2 * frame.half_width;
    const double py = (middle_y - y) / frame.image.height * 2 * frame.half_height;
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d off = px * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
