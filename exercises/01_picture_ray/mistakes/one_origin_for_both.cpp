// hint: starts_at_the_picture
// or: orthographic_origin
// One origin for both projections, a metre before the eye; only the direction is chosen.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double s = x / frame.image.width, t = y / frame.image.height;
    const Vec3d left = -frame.half_width * frame.right, top = frame.half_height * frame.up;
    const Vec3d screen = frame.eye + frame.forward + (1 - 2 * s) * left + (1 - 2 * t) * top;
    const Vec3d way = frame.projection == CameraFrame::Projection::perspective ? screen - frame.eye : frame.forward;
    return {screen, glm::normalize(way), {0, std::numeric_limits<double>::infinity()}};
}
