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

/// Where the ray reaches the face of the cell that is ahead on this axis; absent where it never does.
inline std::optional<Exit> ahead(const Arguments& given, std::size_t axis) {
    const auto i = static_cast<int>(axis);
    const long double d = given.ray.direction[i];
    if (d == 0) return std::nullopt;
    const int side = d > 0 ? 1 : -1;
    const long double plane =
        given.grid.low[i] + (given.cell[axis] + (side > 0 ? 1 : 0)) * static_cast<long double>(given.grid.side);
    const long double t = (plane - given.ray.origin[i]) / d;
    return Exit{axis, side, t, std::min(inside(given, (axis + 1) % 3, t), inside(given, (axis + 2) % 3, t))};
}

inline std::optional<Exit> exit_of(const Arguments& given) {
    std::optional<Exit> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto exit = ahead(given, axis);
        if (exit && (!best || exit->margin > best->margin)) best = exit;
    }
    return best;
}

inline std::optional<Cell> across(const Arguments& given, const Exit& exit) {
    if (exit.t > static_cast<long double>(given.ray.range.max)) return std::nullopt;
    Cell next = given.cell;
    next[exit.axis] += exit.side;
    const bool there = next[exit.axis] >= 0 && next[exit.axis] < given.grid.cells[exit.axis];
    return there ? std::optional(next) : std::nullopt;
}

/// The next cell, if there is one.
inline std::optional<Cell> truth(const Arguments& given) {
    const auto exit = exit_of(given);
    return exit ? across(given, *exit) : std::nullopt;
}

/// Whether this cell comes next; through an edge the ray reaches two faces at once, and each will do.
inline bool is_next(const Arguments& given, const std::optional<Cell>& cell) {
    const auto exit = exit_of(given);
    if (!exit) return !cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto other = ahead(given, axis); other && other->t == exit->t && cell == across(given, *other))
            return true;
    return false;
}

}  // namespace raylab::grading::grid_step
