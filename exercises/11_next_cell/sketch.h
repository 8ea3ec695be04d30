#pragma once

#include "flat_view.h"
#include "symptoms.h"

namespace raylab::grading::next_cell {

/// The cell, the ray through it, the smallest cell that it may enter, and an answer's point.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const Truth true_cell = truth(given);
    const auto& cube = given.cube;
    Vec3d weight = given.direction / glm::length(given.direction);
    weight[true_cell.axis] = 4;
    const auto [right, up] = longest_axes(weight);
    const Vec3d high = cube.low + Vec3d(cube.side), room(std::max(given.smallest, cube.side / 4));
    FlatView view(right, up, cube.low - room, high + room, "the cell, and a point of the next one");
    view.box(cube.low, high, {.line = case_ink::given, .fill = "#eeeeee", .width = 2});
    const Vec3d low{true_cell.low[0], true_cell.low[1], true_cell.low[2]};
    view.box(low, low + Vec3d(given.smallest), {.line = case_ink::right, .fill = "#bfe8da", .width = 2});
    const Vec3d exit = exit_point(question), unit = glm::normalize(given.direction);
    view.ray(exit - unit * (0.9 * cube.side), exit + unit * (given.smallest + 0.1 * cube.side));
    const Vec3d yours{answer[0], answer[1], answer[2]};
    if (std::isfinite(dot(yours, yours)))
        view.dot(glm::clamp(yours, cube.low - room, high + room), case_ink::yours, "yours");
    else
        view.text((cube.low + high) / 2.0, case_ink::yours, "yours: no number");
    return view.drawn();
}

}  // namespace raylab::grading::next_cell
