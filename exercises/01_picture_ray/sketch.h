#pragma once

#include "flat_view.h"
#include "truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace raylab::grading::picture_rays {

/// Where a ray crosses the plane of the picture, to the right of its middle and upward; absent where it does not,
/// before the eye.
inline std::optional<PicturePoint> crossing(const CameraFrame& frame, const Vec3d& origin, const Vec3d& direction) {
    const Vec3d from = origin - frame.eye;
    const double ahead = dot(direction, frame.forward);
    const bool is_perspective = frame.projection == CameraFrame::Projection::perspective;
    if (is_perspective && !(ahead > 0)) return std::nullopt;
    const double t = is_perspective ? (1 - dot(from, frame.forward)) / ahead : 0;
    const Vec3d at = from + t * direction;
    const PicturePoint point{dot(at, frame.right), dot(at, frame.up)};
    if (!std::isfinite(point.right) || !std::isfinite(point.up)) return std::nullopt;
    return point;
}

/// The picture as the camera has it before it: where the ray has to go through it, and where an answer does.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    const auto& frame = given.frame;
    const double width = frame.half_width, height = frame.half_height, size = std::max(width, height);
    const Vec3d origin{answer[0], answer[1], answer[2]}, direction{answer[3], answer[4], answer[5]};
    FlatView view({-1.3 * width, -1.3 * height, 0}, {1.3 * width, 1.3 * height, 0},
                  fmt::format("the picture, {} x {} pixels, with the point x = {:.4g}, y = {:.4g}", frame.image.width,
                              frame.image.height, given.x, given.y),
                  "to the right and upward as the camera has it");
    view.box({-width, -height, 0}, {width, height, 0}, {.line = case_ink::given, .width = 2});
    view.text({-width, height + 0.06 * size, 0}, case_ink::given, "x = 0, y = 0");
    const auto expected = truth(given);
    const auto right = picture_point(given);
    view.dot({right.right, right.up, 0}, case_ink::right, "right");
    const double off = std::max(glm::length(origin - expected.origin), glm::length(direction - expected.direction));
    const auto yours = crossing(frame, origin, direction);
    if (!std::isfinite(off))
        view.text({0, -1.2 * height, 0}, case_ink::yours, "yours: no number");
    else if (!yours)
        view.text({0, -1.2 * height, 0}, case_ink::yours, "yours: away from the picture");
    else if (std::abs(yours->right) > 1.3 * width || std::abs(yours->up) > 1.3 * height)
        view.text({0, -1.2 * height, 0}, case_ink::yours,
                  fmt::format("yours: beside it, {:.3g} to the right and {:.3g} upward", yours->right, yours->up));
    else
        view.dot({yours->right, yours->up, 0}, case_ink::yours, "yours");
    if (std::isfinite(off))
        view.text({0, -1.38 * height, 0}, case_ink::given,
                  fmt::format("your origin is {:.2g} off, your direction is {:.4g} long",
                              glm::length(origin - expected.origin), glm::length(direction)));
    return view.drawn();
}

}  // namespace raylab::grading::picture_rays
