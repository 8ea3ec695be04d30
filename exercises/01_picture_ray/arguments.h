#pragma once

#include "raylab/scene/camera.h"

#include <span>

namespace raylab::grading::picture_rays {

// eye, right, up, forward; half width and height; 0 perspective or 1 orthographic; width and height in pixels; x, y
inline constexpr std::size_t inputs = 19;
inline constexpr std::size_t outputs = 6;  // origin and direction

struct Arguments {
    CameraFrame frame;
    double x, y;
};

inline Arguments arguments(std::span<const double> in) {
    using enum CameraFrame::Projection;
    return {{.eye = {in[0], in[1], in[2]},
             .right = {in[3], in[4], in[5]},
             .up = {in[6], in[7], in[8]},
             .forward = {in[9], in[10], in[11]},
             .half_width = in[12],
             .half_height = in[13],
             .projection = in[14] == 0 ? perspective : orthographic,
             .image = {static_cast<int>(in[15]), static_cast<int>(in[16])}},
            in[17],
            in[18]};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&picture_ray) function, std::span<const double> in, std::span<double> out) {
    const auto [frame, x, y] = arguments(in);
    const auto ray = function(frame, x, y);
    out[0] = ray.origin.x;
    out[1] = ray.origin.y;
    out[2] = ray.origin.z;
    out[3] = ray.direction.x;
    out[4] = ray.direction.y;
    out[5] = ray.direction.z;
}

}  // namespace raylab::grading::picture_rays
