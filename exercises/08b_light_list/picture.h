#pragma once

#include "arguments.h"
#include "exercise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading::light_list {

// A floor under a light, seen from above, and between them two panes of glass and a plate: round, at depths 1, 2 and 3.
// To the right the floor is higher than the plate; on the left a board fills the cells.
inline constexpr int picture_width = 200, picture_height = 120;
inline constexpr double floor_depth = 4, step_depth = 2.5, board_depth = 0.5;

struct Disk {
    double x, y, radius, begin, through;
};
inline constexpr std::array<Disk, 3> disks{{{80, 50, 32, 1, 0.6}, {115, 65, 36, 2, 0.4}, {140, 60, 34, 3, 0}}};

inline Arguments below(int x, int y) {
    const bool is_step = x >= 130, is_under_board = x < 25;
    Arguments given{is_step ? step_depth : floor_depth, std::numeric_limits<double>::infinity(), {}};
    if (is_under_board) {
        given.entries.push_back({board_depth, 0});
        given.filled = board_depth;
        return given;
    }
    for (const Disk& disk : disks) {
        const double aside = std::hypot(x + 0.5 - disk.x, y + 0.5 - disk.y);
        if (aside > disk.radius + 6) continue;  // not in this cell's list
        // What begins deeper than the floor is not between it and the light.
        given.entries.push_back({disk.begin, aside < disk.radius && disk.begin < given.depth ? disk.through : 1});
    }
    given.entries.push_back({given.depth, 1});  // the floor itself
    std::ranges::sort(given.entries, {}, &Entry::begin);
    return given;
}

inline std::vector<Case> pixel_cases(int x, int y) { return {{"", Case::Kind::graded, as_input(below(x, y))}}; }

/// Grey by the share, and the redder the more was tested.
inline Pixel shade(int, int, std::span<const double> answer) {
    if (!std::isfinite(answer[0])) return {0.8f, 0, 0.5f};
    const auto grey = cast<float>(0.05 + 0.75 * std::clamp(answer[0], 0.0, 1.2));
    return {std::min(1.0f, grey + cast<float>(std::clamp(answer[1] / 12, 0.0, 1.0))), grey, grey};
}

}  // namespace raylab::grading::light_list
