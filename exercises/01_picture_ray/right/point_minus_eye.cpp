// The picture point, then the difference to the eye.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity(), w = frame.image.width, h = frame.image.height;
    const Vec3d step =
        frame.half_width * (2 * x - w) / w * frame.right + frame.half_height * (h - 2 * y) / h * frame.up;
    switch (frame.projection) {
        case CameraFrame::Projection::orthographic:
            return {frame.eye + step, frame.forward, {0, inf}};
        default:
            return {frame.eye, glm::normalize(frame.forward + step), {0, inf}};
    }
}
