#pragma once

#include "arguments.h"

#include <cmath>
#include <optional>

// The truth, from the definition of a face: the ray leaves through the face whose square contains its intersection with
// the face's plane. It is computed in long double, and without comparing t.

namespace raylab::grading::grid_step {

struct Exit {
    std::size_t axis = 0;
    int side = 0;  // +1 or -1
    long double t = 0;
    long double margin = 0;  // distance from the square's nearest edge, in sides of a cell
};

/// How far the ray, at its intersection with a plane, is inside the cell on another axis: in sides, negative outside.
inline long double inside(const Arguments& given, std::size_t axis, long double t) {
    const auto i = static_cast<int>(axis);
    const long double x = given.ray.origin[i] + t * static_cast<long double>(given.ray.direction[i]);
    const long double place = (x - given.grid.low[i]) / given.grid.side - given.cell[axis];
    return std::min(place, 1 - place);
}

inline std::optional<Exit> exit_of(const Arguments& given) {
    std::optional<Exit> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const long double d = given.ray.direction[i];
        if (d == 0) continue;
        const int side = d > 0 ? 1 : -1;
        const long double plane =
            given.grid.low[i] + (given.cell[axis] + (side > 0 ? 1 : 0)) * static_cast<long double>(given.grid.side);
        const long double t = (plane - given.ray.origin[i]) / d;
        const long double margin = std::min(inside(given, (axis + 1) % 3, t), inside(given, (axis + 2) % 3, t));
        if (!best || margin > best->margin) best = Exit{axis, side, t, margin};
    }
    return best;
}

/// The next cell, if there is one.
inline std::optional<Cell> truth(const Arguments& given) {
    const auto exit = exit_of(given);
    if (!exit || exit->t > static_cast<long double>(given.ray.range.max)) return std::nullopt;
    Cell next = given.cell;
    next[exit->axis] += exit->side;
    const bool there = next[exit->axis] >= 0 && next[exit->axis] < given.grid.cells[exit->axis];
    return there ? std::optional(next) : std::nullopt;
}

}  // namespace raylab::grading::grid_step
