#pragma once

#include "flat_view.h"
#include "symptoms.h"

namespace raylab::grading::grid_step {

/// The cell among its neighbours, the ray through it, the cell that comes next and an answer's.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const auto exit = exit_of(given);
    const double side = given.grid.side;
    const auto low_of = [&](const Cell& cell) { return given.grid.low + side * Vec3d{cell[0], cell[1], cell[2]}; };
    const bool is_cell = answer[0] != 0 && std::ranges::all_of(answer, [](double x) { return std::abs(x) < 1e9; });
    Cell yours{};
    if (is_cell)
        for (std::size_t i = 0; i < 3; ++i) yours[i] = static_cast<int>(answer[i + 1]);
    // The axis that the ray leaves by, and one on which the answer differs, or the direction is longest.
    const auto across = static_cast<int>(exit->axis);
    Vec3d weight = given.ray.direction / glm::length(given.ray.direction);
    for (std::size_t i = 0; i < 3; ++i)
        if (is_cell && yours[i] != given.cell[i]) weight[static_cast<int>(i)] = 2;
    weight[across] = 4;
    const auto [right, up] = longest_axes(weight);
    const Vec3d low = low_of(given.cell), high = low + Vec3d(side);
    FlatView view(right, up, low - Vec3d(side), high + Vec3d(side),
                  "the cell, its neighbours, and where the ray goes on");
    const auto fill = [&](const Cell& cell, const char* color, const std::string& words) {
        view.box(low_of(cell), low_of(cell) + Vec3d(side), {.line = color, .fill = {}, .width = 4});
        view.text(low_of(cell) + Vec3d(side / 2), color, words);
    };
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            Cell cell = given.cell;
            cell[static_cast<std::size_t>(right)] += i;
            cell[static_cast<std::size_t>(up)] += j;
            view.box(low_of(cell), low_of(cell) + Vec3d(side), {.line = case_ink::faint, .width = 1});
        }
    view.box(low, high, {.line = case_ink::given, .fill = "#eeeeee", .width = 2});
    const auto leave = static_cast<double>(exit->t), more = 0.7 * side / glm::length(given.ray.direction);
    const auto point = [&](double t) { return given.ray.origin + t * given.ray.direction; };
    view.ray(point(leave - 2 * more), point(std::min(leave + more, given.ray.range.max)));
    const auto next = truth(given);
    if (next) fill(*next, case_ink::right, "right");
    if (is_cell) fill(yours, case_ink::yours, next == yours ? "" : "yours");
    if (!next) view.text(low + Vec3d(0.25 * side), case_ink::right, "right: no next cell");
    if (!is_cell) view.text(low + Vec3d(0.1 * side), case_ink::yours, "yours: none");
    return view.drawn();
}

}  // namespace raylab::grading::grid_step
