// hint: whole_numbers
// Counts pixels from the middle one, which half of an odd number of them is not.
#include "raylab/scene/camera.h"

#include <cmath>
#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto steps = [](double place, int pixels) { return place - pixels / 2; };
    const Vec3d pixel_right = frame.right * (2 * frame.half_width / frame.image.width);
    const Vec3d pixel_down = frame.up * (-2 * frame.half_height / frame.image.height);
    const Vec3d aside = steps(x, frame.image.width) * pixel_right + steps(y, frame.image.height) * pixel_down;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + aside, frame.forward, {0, infinity}};
    const Vec3d way = frame.forward + aside;
    return {frame.eye, way / std::sqrt(dot(way, way)), {0, infinity}};
}
