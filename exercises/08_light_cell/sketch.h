#pragma once

#include "flat_view.h"
#include "truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

namespace raylab::grading::cells {

inline std::string cell_words(double face, double column, double row) {
    constexpr std::array names{"+x", "-x", "+y", "-y", "+z", "-z"};
    const bool known = face >= 0 && face < 6 && face == std::floor(face);
    return fmt::format("face {}{}, column {}, row {}", face,
                       known ? fmt::format(" ({})", names[static_cast<std::size_t>(face)]) : "", column, row);
}

/// The face that the direction goes through, with the right cell in it and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    const LightCell right = found_cell(given);
    const Seen seen = seen_through(given.direction, right.face);
    const double width = 2.0 / given.resolution;
    const bool is_fine = given.resolution > 40;  // then the cells around the right one are enough
    const auto border = [&](double number) { return number * width - 1; };
    const double u = static_cast<double>(seen.u / seen.w), v = static_cast<double>(seen.v / seen.w);
    const Vec3d low{is_fine ? border(right.column - 5) : -1, is_fine ? border(right.row - 5) : -1, 0};
    const Vec3d high{is_fine ? border(right.column + 6) : 1, is_fine ? border(right.row + 6) : 1, 0};
    FlatView view(low, high, fmt::format("face {}: columns to the right, rows upward", right.face),
                  fmt::format("the dot is u / w = {:.4g}, v / w = {:.4g}", u, v));
    const auto box = [&](double column, double row, const PlaneStyle& style) {
        view.box({border(column), border(row), 0}, {border(column + 1), border(row + 1), 0}, style);
    };
    for (int i = 0; i <= given.resolution; ++i) {
        const double at = border(i);
        if (at >= low.x - 1e-9 && at <= high.x + 1e-9)
            view.box({at, low.y, 0}, {at, high.y, 0}, {.line = case_ink::faint});
        if (at >= low.y - 1e-9 && at <= high.y + 1e-9)
            view.box({low.x, at, 0}, {high.x, at, 0}, {.line = case_ink::faint});
    }
    box(right.column, right.row, {.line = case_ink::right, .fill = "#d5f0e6", .width = 4});
    const bool is_here = answer[0] == right.face && border(answer[1]) >= low.x && border(answer[1]) < high.x &&
                         border(answer[2]) >= low.y && border(answer[2]) < high.y;
    if (is_here) box(answer[1], answer[2], {.line = case_ink::yours, .width = 2});
    view.dot({u, v, 0}, case_ink::given, "");
    const Vec3d below{(low.x + high.x) / 2, low.y - 0.05 * (high.y - low.y), 0};
    const bool is_number = std::ranges::all_of(answer, [](double value) { return std::isfinite(value); });
    view.text(below, case_ink::yours,
              "yours: " + (is_number ? cell_words(answer[0], answer[1], answer[2]) : "no number"));
    view.text({below.x, high.y + 0.04 * (high.y - low.y), 0}, case_ink::right,
              "right: " + cell_words(right.face, right.column, right.row));
    return view.drawn();
}

}  // namespace raylab::grading::cells
