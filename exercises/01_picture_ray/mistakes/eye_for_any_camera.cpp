// hint: orthographic_origin
// The projection chooses a direction alone: both kinds of rays begin at the eye.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const Vec3d across = (2 * frame.half_width / frame.image.width) * frame.right;
    const Vec3d down = (-2 * frame.half_height / frame.image.height) * frame.up;
    Vec3d way = frame.forward;
    if (frame.projection == CameraFrame::Projection::perspective) {
        way += frame.half_height * frame.up - frame.half_width * frame.right;
        way += x * across + y * down;
    }
    return {frame.eye, glm::normalize(way), {0, std::numeric_limits<double>::infinity()}};
}
