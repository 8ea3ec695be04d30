// hint: half_sizes_missing
// The picture's corner is one step to the left and one upward, and a pixel is 2 over their number.
#include "raylab/scene/camera.h"

#include <limits>

raylab::RayOf<double> raylab::picture_ray(const CameraFrame& frame, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3d corner = frame.up - frame.right;
    const Vec3d across = frame.right * (2.0 / frame.image.width);
    const Vec3d down = -frame.up * (2.0 / frame.image.height);
    const Vec3d from_middle = corner + across * x + down * y;
    const bool is_flat = frame.projection == CameraFrame::Projection::orthographic;
    const Vec3d origin = is_flat ? frame.eye + from_middle : frame.eye;
    const Vec3d way = is_flat ? frame.forward : frame.forward + from_middle;
    return {origin, way / glm::length(way), {0, infinity}};
}
