#pragma once

#include "arguments.h"
#include "exercise.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading::halves {

// A room with three large panes of coloured glass, one across each axis. A pane tints what is behind it where the
// function has the ray visit both halves of the room.
inline constexpr int picture_width = 240, picture_height = 160;
inline constexpr Vec3d room_low{-3, -2, 0}, room_high{3, 2, 8}, eye{0.5, 0.25, 0.5}, panes{1.5, -0.75, 5};

inline Vec3d room_direction(int x, int y) {
    const double scale = 1.5 / picture_height;
    return {(x - picture_width / 2) * scale, (picture_height / 2 - y) * scale, 1};  // the middle ones are exactly 0
}

/// The t at which a ray from the eye reaches a wall.
inline double wall(const Vec3d& direction) {
    double t = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = direction[axis];
        if (d != 0) t = std::min(t, ((d > 0 ? room_high[axis] : room_low[axis]) - eye[axis]) / d);
    }
    return t;
}

inline std::vector<Case> pixel_cases(int x, int y) {
    const Vec3d direction = room_direction(x, y);
    std::vector<Case> all;
    for (int axis = 0; axis < 3; ++axis)
        all.push_back(
            {"", Case::Kind::graded, as_input({eye[axis], direction[axis], panes[axis], {0, wall(direction)}})});
    return all;
}

/// What one pane lets through: the colour depends on which half is visited first, the strength on how far off the pane
/// is, and a room's upper half is a little lighter than its lower one.
inline Vec3d pane_tint(int axis, std::span<const double> answer, double end) {
    constexpr std::array<Vec3d, 3> from_below{Vec3d{0.4, 0.8, 1}, Vec3d{1, 0.85, 0.35}, Vec3d{0.6, 1, 0.6}};
    constexpr std::array<Vec3d, 3> from_above{Vec3d{1, 0.5, 0.5}, Vec3d{0.7, 0.5, 1}, Vec3d{1, 0.6, 0.9}};
    const auto visited = read_halves(answer);
    if (visited.empty()) return {0.3, 0, 0.3};
    const bool below = visited[0].half == CellHalf::below;
    if (visited.size() == 1) return Vec3d(below ? 0.9 : 1);
    const double t = visited[0].range.max;
    if (!(t >= 0 && t <= end) || t != visited[1].range.min) return {0.3, 0, 0.3};  // the parts do not meet
    const auto& tint = (below ? from_below : from_above)[static_cast<std::size_t>(axis)];
    return tint + (Vec3d(1) - tint) * std::min(0.8, t / 10);
}

inline Pixel shade(int x, int y, std::span<const double> answers) {
    const Vec3d direction = room_direction(x, y);
    const double end = wall(direction);
    const Vec3d point = eye + end * direction;
    const bool dark =
        (static_cast<int>(std::floor(point.x + 1e-9) + std::floor(point.y + 1e-9) + std::floor(point.z + 1e-9)) & 1) !=
        0;
    Vec3d color(dark ? 0.75 : 0.95);
    for (int axis = 0; axis < 3; ++axis)
        color = color * pane_tint(axis, answers.subspan(static_cast<std::size_t>(axis) * outputs, outputs), end);
    return {cast<float>(color.x), cast<float>(color.y), cast<float>(color.z)};
}

}  // namespace raylab::grading::halves
