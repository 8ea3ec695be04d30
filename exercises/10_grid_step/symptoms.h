#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>

// What wrong answers to this exercise have in common.

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

/// Whether the answer is the step across the plane ahead that is reached first in this grid, or that leads out of it.
inline bool is_step_in(const Arguments& given, const WrongAnswer& w) {
    std::optional<Exit> first;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto exit = ahead(given, axis); exit && (!first || exit->t < first->t)) first = exit;
    const auto next = across(given, *first);
    if (!next) return w.given[0] == 0;
    return w.given[0] == 1 && w.given[1] == (*next)[0] && w.given[2] == (*next)[1] && w.given[3] == (*next)[2];
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"one_face", "you cross two faces or three at once, at an edge", [](const WrongAnswer& w) {
             return w.given[0] == 1 && axes_of(step(w, w.given)) > 1 && exit_of(of(w.question))->margin == 0;
         }});
    add({"end_of_ray", "the range ends in the cell, or on its face", [](const WrongAnswer& w) {
             const auto given = of(w.question);
             const double end = given.ray.range.max, exit = static_cast<double>(exit_of(given)->t);
             return std::isfinite(end) && (says_one(w) ? exit > end : says_none(w) && exit <= end);
         }});
    add({"end_of_grid", "the ray leaves the grid, and you give a cell",
         [](const WrongAnswer& w) { return says_one(w) && leaves_grid(w.question); }});
    add({"end_of_grid", "the next cell is the first or the last of its row, and you give none",
         [](const WrongAnswer& w) {
             const auto exit = exit_of(of(w.question));
             const auto given = of(w.question);
             const int next = given.cell[exit->axis] + exit->side;
             return says_none(w) && (next == 0 || next == given.grid.cells[exit->axis] - 1);
         }});
    add({"parallel", "a coordinate of the direction is 0", [](const WrongAnswer& w) { return is_parallel(w.question); },
         [](const Case& q) { return is_parallel(q) && !leaves_grid(q) && !ends_before(q); }});
    add({"sign", "the axis is right, and you step up where the ray goes down", [](const WrongAnswer& w) {
             if (!goes_down(w.question) || w.given[0] == 0) return goes_down(w.question) && leaves_grid(w.question);
             const auto mine = step(w, w.given);
             const auto exit = exit_of(of(w.question));
             return axes_of(mine) == 1 && axis_of(mine) == exit->axis && mine[exit->axis] > 0;
         }});
    add({"sign",
         "the axis is right, and you step the other way",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             const auto exit = exit_of(of(w.question));
             return w.given[0] == 1 && axes_of(mine) == 1 && axis_of(mine) == exit->axis &&
                    mine[exit->axis] == -exit->side;
         },
         {},
         says_none});
    for (const int side : {0, 1})
        add({"sign",
             "your planes are those on one side of the cell, whichever way the ray goes",
             [side](const WrongAnswer& w) { return is_step_by_planes_on(w, side); },
             {},
             [](const WrongAnswer& w) { return says_none(w) && goes_down_an_axis(w); }});
    for (const std::size_t counted : {0u, 1u, 2u})
        add({"end_of_grid", "the number of cells along one axis is taken for all axes",
             [counted](const WrongAnswer& w) {
                 const auto exit = exit_of(of(w.question));
                 const auto given = of(w.question);
                 const int next = given.cell[exit->axis] + exit->side;
                 const bool is_in = next >= 0 && next < given.grid.cells[counted];
                 return is_in ? says_one(w) && axes_of(step(w, w.given)) == 1 && !ends_before(w.question)
                              : says_none(w);
             },
             [counted](const Case& q) {
                 const auto exit = exit_of(of(q));
                 const auto given = of(q);
                 const int next = given.cell[exit->axis] + exit->side;
                 return !ends_before(q) && next >= 0 &&
                        (next < given.grid.cells[counted]) != (next < given.grid.cells[exit->axis]);
             }});
    add({"not_ahead", "you leave out the plane that is reached first, since its t is small or not positive",
         [](const WrongAnswer& w) {
             const auto exit = exit_of(of(w.question));
             const auto mine = step(w, w.given);
             const bool is_later = w.given[0] == 0 || (axes_of(mine) == 1 && axis_of(mine) != exit->axis);
             return is_later && exit->t < 0.02L;
         },
         [](const Case& q) { return exit_of(of(q))->t < 1e-4L && !leaves_grid(q); }});
    add({"no_step", "you give the cell in which the ray is",
         [](const WrongAnswer& w) { return w.given[0] == 1 && axes_of(step(w, w.given)) == 0; }});
    // None is what a search beyond the grid finds.
    add({"step_and_search",
         "you give a cell that is no neighbour across one face",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             double farthest = 0;
             for (const double x : mine) farthest = std::max(farthest, std::abs(x));
             return w.given[0] == 1 && (axes_of(mine) != 1 || farthest > 1);
         },
         {},
         [](const WrongAnswer& w) { return says_none(w) && !std::isfinite(of(w.question).ray.range.max); }});
    add({"longest_component", "you step along the axis of the direction's largest component",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             const auto& d = of(w.question).ray.direction;
             const std::array sizes{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
             return w.given[0] == 1 && axes_of(mine) == 1 && sizes[axis_of(mine)] == *std::ranges::max_element(sizes);
         },
         [](const Case& q) {
             const auto& d = of(q).ray.direction;
             const std::array sizes{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
             return exit_of(of(q))->margin > 0 && sizes[exit_of(of(q))->axis] != *std::ranges::max_element(sizes);
         },
         says_none});
    add({"sign",
         "you step along an axis that the ray goes down, and it does not leave there",
         [](const WrongAnswer& w) {
             const auto& d = of(w.question).ray.direction;
             const auto mine = step(w, w.given);
             const bool is_right_axis = w.right[0] == 1 && axis_of(mine) == exit_of(of(w.question))->axis;
             return w.given[0] == 1 && axes_of(mine) == 1 && !is_right_axis && d[static_cast<int>(axis_of(mine))] < 0;
         },
         {},
         [](const WrongAnswer& w) { return says_none(w) && goes_down_an_axis(w); }});
    add({"sign", "a coordinate of the direction is negative", goes_down_an_axis});
    // What a mistake about which plane comes first does, it does to rays that go up, too.
    add({"nearest_plane",
         "you cross the face that is reached last",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             if (w.given[0] == 0 || axes_of(mine) != 1) return false;
             for (std::size_t axis = 0; axis < 3; ++axis)
                 if (reached(w.question, axis) < 1e300 &&
                     reached(w.question, axis) > reached(w.question, axis_of(mine)))
                     return false;
             return true;
         },
         {},
         says_none});
    add({"nearest_plane",
         "you step along the first axis along which the ray moves",
         [](const WrongAnswer& w) { return is_step_along(w, first_moving(w.question)); },
         {},
         says_none});
    add({"nearest_plane",
         "you step along the last axis along which the ray moves",
         [](const WrongAnswer& w) { return is_step_along(w, last_moving(w.question)); },
         {},
         says_none});
    add({"where_planes", "your planes are those of a grid that begins at 0", [](const WrongAnswer& w) {
             auto given = of(w.question);
             given.grid.low = {0, 0, 0};
             return is_step_in(given, w);
         }});
    add({"where_planes", "your planes are those of cells that are 1 wide", [](const WrongAnswer& w) {
             auto given = of(w.question);
             given.grid.side = 1;
             return is_step_in(given, w);
         }});
    add({"where_planes",
         "your upper planes are 1 above the lower ones, not a side",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             std::optional<std::size_t> first;
             double first_t = 0;
             for (std::size_t axis = 0; axis < 3; ++axis) {
                 const auto i = static_cast<int>(axis);
                 const double d = given.ray.direction[i], up = d > 0 ? 1 : 0;
                 if (d == 0) continue;
                 const double plane = given.grid.low[i] + given.cell[axis] * given.grid.side + up;
                 const double t = (plane - given.ray.origin[i]) / d;
                 if (!first || t < first_t) first = axis, first_t = t;
             }
             return first && is_step_along(w, *first);
         },
         {},
         says_none});
    add({"longest_component",
         "you step along the axis of the direction's smallest component",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             const auto& d = of(w.question).ray.direction;
             const std::array sizes{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
             return w.given[0] == 1 && axes_of(mine) == 1 && sizes[axis_of(mine)] == *std::ranges::min_element(sizes);
         },
         {},
         says_none});
    return all;
}

}  // namespace raylab::grading::grid_step
