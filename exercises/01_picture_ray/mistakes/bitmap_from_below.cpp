// hint: row_from_the_bottom
// Goes up from the lower left corner, as a bitmap's rows do: of y that leaves height - 1 - y.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3d lower_left = -frame.half_width * frame.right - frame.half_height * frame.up;
    const Vec3d bottom_edge = 2 * frame.half_width * frame.right;
    const Vec3d left_edge = 2 * frame.half_height * frame.up;
    const double s = x / frame.image.width;
    const double t = (frame.image.height - 1 - y) / frame.image.height;
    const Vec3d place = lower_left + s * bottom_edge + t * left_edge;
    if (frame.projection == CameraFrame::Projection::perspective)
        return {frame.eye, glm::normalize(place + frame.forward), {0, infinity}};
    return {frame.eye + place, frame.forward, {0, infinity}};
}
