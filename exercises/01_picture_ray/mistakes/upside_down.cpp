// hint: upside_down
// y counts from the top edge, but up is taken to grow with it.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double right = (2 * x / frame.image.width - 1) * frame.half_width;
    const double up = (2 * y / frame.image.height - 1) * frame.half_height;
    const Vec3d aside = right * frame.right + up * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + aside, frame.forward, {0, infinity}};
    return {frame.eye, glm::normalize(frame.forward + aside), {0, infinity}};
}
