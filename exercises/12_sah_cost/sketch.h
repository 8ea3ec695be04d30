#pragma once

#include "arguments.h"
#include "case.h"
#include "flat_view.h"
#include "truth.h"

#include <fmt/format.h>

namespace raylab::grading::cuts {

/// The cell from the side, cut by the plane, with both costs in numbers.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const SahCut cut = arguments(question.input);
    const double along = cut.size[cut.axis],
                 other = std::max(cut.size[(cut.axis + 1) % 3], cut.size[(cut.axis + 2) % 3]);
    // A long thin cell is shown less long, and one without any size as a point.
    const double longest = std::max(along, other), scale = longest > 0 ? 1 / longest : 0;
    const Vec3d size{std::max(along * scale, 0.02), std::max(other * scale, 0.02), 0};
    const double place = along > 0 ? cut.place / along * size.x : 0;
    FlatView view({0, -0.25, 0}, {std::max(size.x, 0.6), size.y, 0}, "the cell, cut by the plane",
                  "the cut axis to the right, the longer of the others upward");
    view.box({0, 0, 0}, size, {.line = case_ink::given, .fill = "#e8e8e8", .width = 2});
    view.polygon({{place, -0.05, 0}, {place, size.y + 0.05, 0}}, {.line = case_ink::given, .width = 3});
    view.text({place / 2, size.y / 2, 0}, case_ink::given, fmt::format("{:g}", cut.below));
    view.text({(place + size.x) / 2, size.y / 2, 0}, case_ink::given, fmt::format("{:g}", cut.above));
    const auto cost = [](double value) {
        return std::isnan(value) ? "no number" : std::isinf(value) ? "without end" : fmt::format("{:.6g}", value);
    };
    const auto right = static_cast<double>(truth(cut).cost);
    view.text({size.x / 2, -0.15, 0}, case_ink::right, "right: " + cost(right));
    view.text({size.x / 2, -0.25, 0}, case_ink::yours, "yours: " + cost(answer[0]));
    return view.drawn();
}

}  // namespace raylab::grading::cuts
