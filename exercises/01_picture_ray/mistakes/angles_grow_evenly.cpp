// hint: equal_angles
// Each pixel has the same share of the angle of view, not of the picture.
#include "raylab/scene/camera.h"

#include <cmath>
#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const bool is_flat = frame.projection == CameraFrame::Projection::orthographic;
    const auto place = [is_flat](double share, double half) {
        return is_flat ? share * half : std::tan(share * std::atan(half));
    };
    const double px = place(2 * x / frame.image.width - 1, frame.half_width);
    const double py = place(1 - 2 * y / frame.image.height, frame.half_height);
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d off = px * frame.right + py * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + off, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(frame.forward + off), {0, inf}};
}
