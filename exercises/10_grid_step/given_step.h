#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>

// The step that an answer takes, and what of a case may mislead it.

namespace raylab::grading::grid_step {

inline Arguments of(const Case& question) { return arguments(question.input); }

/// The step that an answer takes along each axis.
inline std::array<double, 3> step(const WrongAnswer& w, std::span<const double> answer) {
    const Cell cell = of(w.question).cell;
    return {answer[1] - cell[0], answer[2] - cell[1], answer[3] - cell[2]};
}
inline std::size_t axes_of(const std::array<double, 3>& step) {
    return static_cast<std::size_t>(std::ranges::count_if(step, [](double x) { return x != 0; }));
}
inline std::size_t axis_of(const std::array<double, 3>& step) {
    return static_cast<std::size_t>(std::ranges::find_if(step, [](double x) { return x != 0; }) - step.begin());
}

inline bool says_none(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 0; }
inline bool says_one(const WrongAnswer& w) { return w.right[0] == 0 && w.given[0] == 1; }
inline bool both(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 1; }

inline bool is_parallel(const Case& question) {
    const auto& d = of(question).ray.direction;
    return d.x == 0 || d.y == 0 || d.z == 0;
}
inline bool has_minus_zero(const Case& question) {
    const auto& d = of(question).ray.direction;
    const auto is_minus_zero = [](double x) { return x == 0 && std::signbit(x); };
    return is_minus_zero(d.x) || is_minus_zero(d.y) || is_minus_zero(d.z);
}
inline bool leaves_grid(const Case& question) {
    const auto given = of(question);
    const auto exit = exit_of(given);
    const int next = given.cell[exit->axis] + exit->side;
    return next < 0 || next >= given.grid.cells[exit->axis];
}
inline bool ends_before(const Case& question) {
    const auto given = of(question);
    return exit_of(given)->t > static_cast<long double>(given.ray.range.max);
}
/// Whether there is a next cell, and only one.
inline bool has_one_next(const Case& question) {
    return exit_of(of(question))->margin > 0 && !leaves_grid(question) && !ends_before(question);
}
inline bool goes_down(const Case& question) { return exit_of(of(question))->side < 0; }
inline double speed_of(const Case& question) { return glm::length(of(question).ray.direction); }

/// The t at which the ray reaches the plane ahead on this axis, or the plane behind it.
inline double reached(const Case& question, std::size_t axis) {
    const auto exit = ahead(of(question), axis);
    return exit ? static_cast<double>(exit->t) : 1e300;
}

inline bool goes_down_an_axis(const WrongAnswer& w) {
    const auto& d = of(w.question).ray.direction;
    return d.x < 0 || d.y < 0 || d.z < 0;
}

inline std::size_t first_moving(const Case& question) {
    const auto& d = of(question).ray.direction;
    return d.x != 0 ? 0 : d.y != 0 ? 1 : 2;
}
inline std::size_t last_moving(const Case& question) {
    const auto& d = of(question).ray.direction;
    return d.z != 0 ? 2 : d.y != 0 ? 1 : 0;
}
inline bool is_step_along(const WrongAnswer& w, std::size_t axis) {
    const auto mine = step(w, w.given);
    return w.given[0] == 1 && axes_of(mine) == 1 && axis_of(mine) == axis;
}

/// Whether the answer is the step across the plane that is reached first of the cell's lower ones (side 0) or upper
/// ones (1), in the ray's direction.
inline bool is_step_by_planes_on(const WrongAnswer& w, int side) {
    const auto given = of(w.question);
    std::optional<std::size_t> first;
    double first_t = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const double d = given.ray.direction[i];
        if (d == 0) continue;
        const double t = (given.grid.low[i] + (given.cell[axis] + side) * given.grid.side - given.ray.origin[i]) / d;
        if (!first || t < first_t) first = axis, first_t = t;
    }
    return first && is_step_along(w, *first) &&
           step(w, w.given)[*first] * given.ray.direction[static_cast<int>(*first)] > 0;
}

/// Whether a plane by which the ray came into the cell lies ahead of its origin.
inline bool is_from_outside(const Case& question) {
    const auto given = of(question);
    for (int i = 0; i < 3; ++i) {
        const double d = given.ray.direction[i], low = given.grid.low[i] + given.cell[i] * given.grid.side;
        if (d != 0 && ((d > 0 ? low : low + given.grid.side) - given.ray.origin[i]) / d > 0) return true;
    }
    return false;
}
/// Whether the answer is a step along one axis, against the direction.
inline bool is_step_back(const WrongAnswer& w) {
    const auto mine = step(w, w.given);
    const std::size_t axis = axis_of(mine);
    return axes_of(mine) == 1 && mine[axis] * of(w.question).ray.direction[static_cast<int>(axis)] < 0;
}

/// Whether the ray goes a millionth or so along the axis of its exit while t grows by one, and the answer is none or
/// another axis.
inline bool leaves_a_short_axis_out(const WrongAnswer& w) {
    const auto exit = exit_of(of(w.question));
    const bool is_short = std::abs(of(w.question).ray.direction[static_cast<int>(exit->axis)]) < 1e-5;
    return is_short && (w.given[0] == 0 || !is_step_along(w, exit->axis));
}

}  // namespace raylab::grading::grid_step
