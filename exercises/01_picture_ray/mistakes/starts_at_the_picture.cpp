// hint: starts_at_the_picture
// The point of the picture that a direction was made of is where the ray begins, too.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double right = (2 * x / frame.image.width - 1) * frame.half_width;
    const double up = (1 - 2 * y / frame.image.height) * frame.half_height;
    const Vec3d aside = right * frame.right + up * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + aside, frame.forward, {0, infinity}};
    const Vec3d point = frame.eye + frame.forward + aside;
    return {point, glm::normalize(point - frame.eye), {0, infinity}};
}
