// hint: few_digits
// The place in the picture in floats.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const float px = 2 * static_cast<float>(x) / static_cast<float>(frame.image.width) - 1;
    const float py = 1 - 2 * static_cast<float>(y) / static_cast<float>(frame.image.height);
    const Vec3d off = px * frame.half_width * frame.right + py * frame.half_height * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
