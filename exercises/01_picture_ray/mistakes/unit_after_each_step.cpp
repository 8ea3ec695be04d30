// hint: unit_in_between
// Makes the direction unit after the step to the right, and again after the step upward.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    const double inf = std::numeric_limits<double>::infinity();
    const Vec3d aside = (2 * x / frame.image.width - 1) * frame.half_width * frame.right;
    const Vec3d up = (1 - 2 * y / frame.image.height) * frame.half_height * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic)
        return {frame.eye + aside + up, frame.forward, {0, inf}};
    return {frame.eye, glm::normalize(glm::normalize(frame.forward + aside) + up), {0, inf}};
}
