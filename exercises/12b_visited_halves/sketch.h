#pragma once

#include "flat_view.h"
#include "symptoms.h"

#include <fmt/format.h>

namespace raylab::grading::halves {

// The drawing has t from left to right and the axis upward; both are scaled to this box.
inline constexpr double sketch_width = 12, sketch_height = 7;

/// The ray's part as a line that goes up or down through the plane; below it the right ranges, and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const auto finite = [](double x, double otherwise) { return std::isfinite(x) ? x : otherwise; };
    const double t_of_plane = given.direction == 0 ? given.range.min : static_cast<double>(crossing(given));
    const double end = finite(given.range.max, std::max(given.range.min, t_of_plane) + 2 * (1 + std::abs(t_of_plane)));
    const double length = end - given.range.min;
    const double from = given.range.min - 0.15 * length, to = end + 0.15 * length;
    const auto across = [&](double t) { return sketch_width * (std::clamp(t, from, to) - from) / (to - from); };
    const auto first = static_cast<double>(place(given, given.range.min)),
               last = static_cast<double>(place(given, end));
    const double low = std::min({first, last, given.plane}), high = std::max({first, last, given.plane});
    const auto up = [&](double x) { return high > low ? 3 + 3.5 * (x - low) / (high - low) : 4.75; };

    PlaneDrawing drawing{.title = "t to the right, the axis upward: the plane, the ray, and the parts of its range",
                         .low = {-1.5, 0},
                         .high = {sketch_width, sketch_height},
                         .notes = {"green: right; red: yours, from the first half that is visited to the last"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    const auto text = [&](PlanePoint at, const std::string& words, const char* color) {
        mark(PlaneDrawing::Text{.at = at, .words = words, .color = color, .halo = "#ffffff"});
    };
    mark(PlaneDrawing::Path{{{0, up(given.plane)}, {sketch_width, up(given.plane)}},
                            {.line = case_ink::given, .width = 2, .dash = PlaneStyle::Dash::dashed}});
    text({-1.4, up(given.plane)}, "plane", case_ink::given);
    mark(PlaneDrawing::Arrow{
        {across(given.range.min), up(first)}, {across(end), up(last)}, {.line = case_ink::given, .width = 2}});
    const auto bars = [&](const std::vector<VisitedHalf>& visited, double height, const char* color,
                          const std::string& whose) {
        text({-1.4, height}, whose, color);
        if (visited.empty()) text({0, height}, "neither half", color);
        for (std::size_t i = 0; i < visited.size(); ++i) {
            const double y = height - 0.45 * static_cast<double>(i);
            const auto& [half, range] = visited[i];
            const std::string side = half == CellHalf::below ? "below" : "above";
            if (std::isnan(range.min) || std::isnan(range.max)) {
                text({0, y}, side + ", in a range that is no number", color);
                continue;
            }
            mark(PlaneDrawing::Path{{{across(range.min), y}, {across(range.max), y}}, {.line = color, .width = 5}});
            text({across(range.max) + 0.1, y}, fmt::format("{}. {}", i + 1, side), color);
        }
    };
    bars(truth(given), 2.2, case_ink::right, "right");
    bars(read_halves(answer), 1, case_ink::yours, "yours");
    return drawing;
}

}  // namespace raylab::grading::halves
