#pragma once

#include "arguments.h"

#include <cmath>

namespace raylab::grading::picture_rays {

/// The point of the picture rectangle at (x, y), in frame coordinates: to the right and upward.
struct PicturePoint {
    double right, up;
};

inline PicturePoint picture_point(const Arguments& given) {
    const auto& [frame, x, y] = given;
    return {(2 * x / frame.image.width - 1) * frame.half_width, (1 - 2 * y / frame.image.height) * frame.half_height};
}

// The truth is computed from properties, not by the formula under test: what the ray must be when measured in the
// camera's frame.
inline RayOf<double> truth(const Arguments& given) {
    const auto& frame = given.frame;
    const auto [right, up] = picture_point(given);
    const Vec3d aside = right * frame.right + up * frame.up;
    if (frame.projection == CameraFrame::Projection::orthographic) return {frame.eye + aside, frame.forward, {}};
    const double length = std::hypot(right, up, 1.0);
    return {frame.eye,
            {(frame.forward.x + aside.x) / length, (frame.forward.y + aside.y) / length,
             (frame.forward.z + aside.z) / length},
            {}};
}

}  // namespace raylab::grading::picture_rays
