// hint: whole_pixels
// Makes whole numbers of x and y, a column and a row, and goes through the middle of that pixel.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto [width, height] = frame.image;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    // In half pixels from the middle: the middle of a pixel is an odd number of them from the edge.
    const double right = frame.half_width / width * (2 * column + 1 - width);
    const double up = frame.half_height / height * (height - 2 * row - 1);
    const Vec3d aside = frame.right * right + frame.up * up;
    switch (frame.projection) {
        case CameraFrame::Projection::perspective:
            return {frame.eye, glm::normalize(frame.forward + aside), {0, infinity}};
        default:
            return {frame.eye + aside, frame.forward, {0, infinity}};
    }
}
