#pragma once

#include "flat_view.h"
#include "symptoms.h"

namespace raylab::grading::boxes {

/// Box, ray and range from the side, with the right entry and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto [ray, low, high] = of(question);
    const auto point = [&](double t) { return ray.origin + t * ray.direction; };
    const auto [right, up] = longest_axes(ray.direction);
    const double size = glm::length(high - low), speed = glm::length(ray.direction);
    const double middle = dot((low + high) / 2.0 - ray.origin, ray.direction) / (speed * speed);
    const double from = middle - 0.9 * size / speed, to = middle + 0.9 * size / speed;  // the line near the box
    const double begin = std::clamp(ray.range.min, from, to), end = std::clamp(ray.range.max, from, to);
    const Vec3d room(0.3 * size);
    FlatView view(right, up, low - room, high + room, "box, ray, and where it is in the box first");
    view.box(low, high, {.line = case_ink::given, .fill = "#e8e8e8", .width = 2});
    view.ray(point(from), point(to), PlaneStyle::Dash::dotted);
    if (begin < end) view.ray(point(begin), point(end));
    if (const auto truth = first_inside(of(question)))
        view.dot(point(std::clamp(static_cast<double>(*truth), from, to)), case_ink::right, "right");
    else
        view.text((low + high) / 2.0, case_ink::right, "right: never in the box");
    if (answer[0] != 0 && std::isfinite(answer[1]))
        view.dot(point(std::clamp(answer[1], from, to)), case_ink::yours, "yours");
    else
        view.text((low + high) / 2.0 - Vec3d(0.2 * size), case_ink::yours, "yours: none");
    return view.drawn();
}

}  // namespace raylab::grading::boxes
