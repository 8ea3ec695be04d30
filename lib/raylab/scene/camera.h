#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// The camera's orthonormal frame and its picture rectangle, from which a pixel's ray is computed.
struct CameraFrame {
    Vec3d eye;
    Vec3d right, up, forward;        // orthonormal; forward points into the scene
    double half_width, half_height;  // perspective: at distance 1 along forward; orthographic: metres
    enum class Projection { perspective, orthographic } projection;
    ImageSize image;
};

/// The largest width and height of a picture, in pixels.
inline constexpr int largest_image_side = 16384;

/// Computes the frame. It throws an Error (naming `source`) for a degenerate camera: eye at target, up parallel to
/// view, fov_y outside (0, 180), ...
CameraFrame camera_frame(const Camera& camera, ImageSize image, const std::string& source = "camera");

/// The ray through a point of the picture given in pixels: x from the left edge, y from the top edge; the center of
/// pixel (i, j) is (i + 0.5, j + 0.5). Its direction has length 1. This is the slot of exercise 01.
RayOf<double> picture_ray(const CameraFrame& frame, double x, double y);

/// The same ray, rounded to floats as accelerators take them; its range begins at its origin and has no end.
inline Ray eye_ray(const CameraFrame& frame, double x, double y) {
    auto ray = picture_ray(frame, x, y);
    return {convert<float>(ray.origin), convert<float>(ray.direction)};
}

}  // namespace raylab
