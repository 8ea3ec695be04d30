// From the picture's top left corner, by steps of one pixel.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3d across = (2 * frame.half_width / frame.image.width) * frame.right;
    const Vec3d down = (-2 * frame.half_height / frame.image.height) * frame.up;
    const Vec3d corner = frame.forward - frame.half_width * frame.right + frame.half_height * frame.up;
    const Vec3d point = corner + x * across + y * down;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + (point - frame.forward), frame.forward, {0, infinity}};
    return {frame.eye, glm::normalize(point), {0, infinity}};
}
