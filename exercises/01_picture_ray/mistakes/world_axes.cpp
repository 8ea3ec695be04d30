// hint: world_axes
// Uses the world's axes in place of the camera's.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double right = (2 * x / frame.image.width - 1) * frame.half_width;
    const double up = (1 - 2 * y / frame.image.height) * frame.half_height;
    const Vec3d aside{right, up, 0};
    const Vec3d forward{0, 0, -1};
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + aside, forward, {0, infinity}};
    return {frame.eye, glm::normalize(forward + aside), {0, infinity}};
}
