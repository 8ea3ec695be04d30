// hint: middle_forgotten
// Takes half_width and half_height for the picture's whole sides: it begins half of them to the left and above.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double pixel_width = frame.half_width / frame.image.width;
    const double pixel_height = frame.half_height / frame.image.height;
    const Vec3d corner = frame.half_height / 2 * frame.up - frame.half_width / 2 * frame.right;
    const Vec3d aside = corner + x * pixel_width * frame.right - y * pixel_height * frame.up;
    switch (frame.projection) {
        case CameraFrame::Projection::orthographic:
            return {frame.eye + aside, frame.forward, {0, infinity}};
        default:
            return {frame.eye, glm::normalize(frame.forward + aside), {0, infinity}};
    }
}
