// hint: half_pixel_twice
// Adds the half pixel that is already in x and y.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double right = (2 * (x + 0.5) / frame.image.width - 1) * frame.half_width;
    const double up = (1 - 2 * (y + 0.5) / frame.image.height) * frame.half_height;
    const Vec3d aside = right * frame.right + up * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + aside, frame.forward, {0, infinity}};
    return {frame.eye, glm::normalize(frame.forward + aside), {0, infinity}};
}
