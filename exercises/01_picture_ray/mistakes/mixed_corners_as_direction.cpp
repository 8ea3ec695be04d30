// hint: point_as_direction
// Mixes the picture's four corners in the world, and forgets to take the eye from the point that comes out.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool is_flat = frame.projection == CameraFrame::Projection::orthographic;
    const Vec3d middle = is_flat ? frame.eye : frame.eye + frame.forward;
    const auto corner = [&](double right, double up) {
        return middle + right * frame.half_width * frame.right + up * frame.half_height * frame.up;
    };
    const double s = x / frame.image.width, t = y / frame.image.height;
    const Vec3d top = glm::mix(corner(-1, 1), corner(1, 1), s);
    const Vec3d bottom = glm::mix(corner(-1, -1), corner(1, -1), s);
    const Vec3d point = glm::mix(top, bottom, t);
    if (is_flat) return {point, frame.forward, {0, infinity}};
    return {frame.eye, glm::normalize(point), {0, infinity}};
}
