#pragma once

#include "given_step.h"

// What wrong answers have in common whose planes stand elsewhere, or of whose planes another one comes first.

namespace raylab::grading::grid_step {

/// The plane ahead for which this number is the least, if any is.
template <class Number>
std::optional<Exit> ahead_with_least(const Arguments& given, const Number& number) {
    std::optional<Exit> first;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto exit = ahead(given, axis); exit && (!first || number(*exit) < number(*first))) first = exit;
    return first;
}

/// Whether the answer is the cell across this plane, or none where that leads out of the grid or the range.
inline bool is_across(const Arguments& given, const Exit& exit, const WrongAnswer& w) {
    const auto next = across(given, exit);
    if (!next) return w.given[0] == 0;
    return w.given[0] == 1 && w.given[1] == (*next)[0] && w.given[2] == (*next)[1] && w.given[3] == (*next)[2];
}

/// Whether the answer is the step across the plane ahead that is reached first in this grid, or that leads out of it.
inline bool is_step_in(const Arguments& given, const WrongAnswer& w) {
    return is_across(given, *ahead_with_least(given, [](const Exit& exit) { return exit.t; }), w);
}

/// Whether the answer is the step across the plane ahead to which fewest metres are left from the origin, along the
/// plane's axis.
inline bool is_step_by_metres(const WrongAnswer& w) {
    const auto given = of(w.question);
    const auto metres = [&](const Exit& exit) {
        return std::abs(exit.t * given.ray.direction[static_cast<int>(exit.axis)]);
    };
    return is_across(given, *ahead_with_least(given, metres), w);
}

inline std::vector<Symptom> symptoms_of_planes() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
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
    add({"nearest_plane", "you cross the plane that is fewest metres from the origin, and not the one with the least t",
         is_step_by_metres,
         [](const Case& q) {
             std::array<double, outputs> right{};
             if (const auto cell = truth(of(q)))
                 right = {1, double((*cell)[0]), double((*cell)[1]), double((*cell)[2])};
             return exit_of(of(q))->margin > 0 && !is_step_by_metres({q, right, right});
         },
         [](const WrongAnswer& w) { return is_step_by_metres(w) || says_none(w); }});
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
    add({"nearest_plane", "you cross the face that is reached last",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             if (w.given[0] == 0 || axes_of(mine) != 1) return false;
             for (std::size_t axis = 0; axis < 3; ++axis)
                 if (reached(w.question, axis) < 1e300 &&
                     reached(w.question, axis) > reached(w.question, axis_of(mine)))
                     return false;
             return true;
         },
         [](const Case& q) { return has_one_next(q) && first_moving(q) != last_moving(q); }, says_none});
    add({"nearest_plane", "you step along the first axis along which the ray moves",
         [](const WrongAnswer& w) { return is_step_along(w, first_moving(w.question)); },
         [](const Case& q) { return has_one_next(q) && exit_of(of(q))->axis != first_moving(q); }, says_none});
    add({"nearest_plane", "you step along the last axis along which the ray moves",
         [](const WrongAnswer& w) { return is_step_along(w, last_moving(w.question)); },
         [](const Case& q) { return has_one_next(q) && exit_of(of(q))->axis != last_moving(q); }, says_none});
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
    add({"longest_component", "you step along the axis of the direction's smallest component",
         [](const WrongAnswer& w) {
             const auto mine = step(w, w.given);
             const auto& d = of(w.question).ray.direction;
             const std::array sizes{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
             return w.given[0] == 1 && axes_of(mine) == 1 && sizes[axis_of(mine)] == *std::ranges::min_element(sizes);
         },
         [](const Case& q) {
             const auto& d = of(q).ray.direction;
             const std::array sizes{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
             return has_one_next(q) && sizes[exit_of(of(q))->axis] != *std::ranges::min_element(sizes);
         },
         says_none});
    return all;
}

}  // namespace raylab::grading::grid_step
