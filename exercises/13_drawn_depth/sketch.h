#pragma once

#include "flat_view.h"
#include "symptoms.h"
#include "words.h"

#include <fmt/format.h>

namespace raylab::grading::drawing_depth {

/// The triangle in the picture, with the depths of its corners, the right depth at the place, and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    std::vector<Vec3d> corners;
    for (const auto& [x, y, depth] : given.corners) corners.emplace_back(x, y, 0.0);
    const Vec3d place{given.x, given.y, 0};
    Vec3d low = place, high = place;
    for (const Vec3d& corner : corners) low = min(low, corner), high = max(high, corner);
    FlatView view(low, high, "the triangle in the picture, and the place that is asked for",
                  "x to the right, y upward; the numbers are depths");
    view.polygon(corners, {.line = case_ink::given, .fill = "#eeeeee", .width = 2});
    for (std::size_t i = 0; i < 3; ++i)
        view.dot(corners[i], case_ink::given, fmt::format("{:.4g}", given.corners[i].depth));
    const auto in_words = [](const std::optional<double>& depth) {
        if (!depth) return std::string("not covered");
        return std::isfinite(*depth) ? fmt::format("{:.6g}", *depth) : std::string("no number");
    };
    view.dot(place, case_ink::right, "right: " + in_words(truth(given)));
    const double step = 0.07 * std::max(high.x - low.x, high.y - low.y);
    view.text(place - Vec3d{0, step, 0}, case_ink::yours,
              "yours: " + in_words(answer[0] == 1 ? std::optional(answer[1]) : std::nullopt));
    return view.drawn();
}

}  // namespace raylab::grading::drawing_depth
