// hint: half_sizes_are_lengths
// Takes the half sizes for half of the angles of view.
#include "raylab/scene/camera.h"

#include <cmath>
#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double px = (2 * x / frame.image.width - 1) * std::tan(frame.half_width);
    const double py = (1 - 2 * y / frame.image.height) * std::tan(frame.half_height);
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d off = px * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
