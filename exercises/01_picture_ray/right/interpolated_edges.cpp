// Interpolates between the edges of the picture, and divides by a length of its own.
#include "raylab/scene/camera.h"

#include <cmath>
#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double s = x / frame.image.width;
    const double t = y / frame.image.height;
    const double right = (1 - s) * -frame.half_width + s * frame.half_width;
    const double up = (1 - t) * frame.half_height + t * -frame.half_height;
    const Vec3d aside = frame.up * up + frame.right * right;
    switch (frame.projection) {
        case CameraFrame::Projection::orthographic:
            return {aside + frame.eye, frame.forward, {0, infinity}};
        case CameraFrame::Projection::perspective:
            break;
    }
    // The frame is orthonormal, so Pythagoras knows the length.
    const double length = std::sqrt(1 + right * right + up * up);
    return {frame.eye, (frame.forward + aside) / length, {0, infinity}};
}
