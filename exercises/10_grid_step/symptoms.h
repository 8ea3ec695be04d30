#pragma once

#include "symptoms_of_planes.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::grid_step {

/// Whether several faces are within a fixed distance of where the ray leaves, whatever that distance is.
inline bool may_be_near_faces(const Case& question) {
    return exit_of(of(question))->margin == 0 || of(question).grid.side < 1e-4;
}

/// Whether several faces are reached within a fixed t of the first one, whatever that t is.
inline bool may_be_near_in_t(const Case& question) {
    return exit_of(of(question))->margin == 0 || speed_of(question) > 1e6;
}

/// Whether the step is over several faces, of those that are ahead.
inline bool is_ahead_across_some_faces(const WrongAnswer& w) {
    const auto mine = step(w, w.given);
    if (w.given[0] != 1 || axes_of(mine) < 2) return false;
    const Vec3d& d = of(w.question).ray.direction;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double along = d[static_cast<int>(axis)];
        if (mine[axis] != 0 && !(mine[axis] * along > 0 && std::abs(mine[axis]) == 1)) return false;
    }
    return true;
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"one_face", "you cross two faces or three at once, at an edge", [](const WrongAnswer& w) {
             return w.given[0] == 1 && axes_of(step(w, w.given)) > 1 && exit_of(of(w.question))->margin == 0;
         }});
    add({"faces_by_tolerance",
         "you cross two faces or three at once, where the ray passes an edge or the cells are micrometres wide",
         [](const WrongAnswer& w) { return may_be_near_faces(w.question) && is_ahead_across_some_faces(w); },
         {},
         [](const WrongAnswer& w) {
             // Beyond the grid there is none; and of huge cells rounding may carry the point off all faces.
             return says_none(w) ? may_be_near_faces(w.question)
                                 : of(w.question).grid.side > 1e4 && axes_of(step(w, w.given)) == 0;
         }});
    add({"faces_by_tolerance",
         "you cross two faces or three at once, where the ray passes an edge or the direction is very long",
         [](const WrongAnswer& w) { return may_be_near_in_t(w.question) && is_ahead_across_some_faces(w); }});
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
    add({"parallel", "a coordinate of the direction is -0",
         [](const WrongAnswer& w) { return has_minus_zero(w.question); },
         [](const Case& q) { return has_minus_zero(q) && has_one_next(q); }});
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
    add({"small_is_not_zero", "the direction is short along the axis that leads out, and you leave that axis out",
         leaves_a_short_axis_out, [](const Case& q) { return speed_of(q) < 1e-9; }, leaves_a_short_axis_out});
    for (const long double limit : {1e-4L, 1e-10L})
        add({"not_ahead", "you leave out the plane that is reached first, since its t is small or not positive",
             [](const WrongAnswer& w) {
                 const auto exit = exit_of(of(w.question));
                 const auto mine = step(w, w.given);
                 const bool is_later = w.given[0] == 0 || (axes_of(mine) == 1 && axis_of(mine) != exit->axis);
                 return is_later && exit->t < 0.02L;
             },
             [limit](const Case& q) { return exit_of(of(q))->t < limit && has_one_next(q); }});
    add({"came_in_by", "the origin lies before the cell, and you go back through a plane by which the ray came in",
         [](const WrongAnswer& w) { return w.given[0] == 1 && is_step_back(w) && is_from_outside(w.question); },
         [](const Case& q) { return is_from_outside(q) && !ends_before(q); },
         // Back may lead out of the grid, and a plane behind may be left out, however the ray goes on.
         [](const WrongAnswer& w) { return w.given[0] == 0 || exit_of(of(w.question))->t < 0.02L; }});
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
         [](const WrongAnswer& w) {
             return says_none(w) && (!std::isfinite(of(w.question).ray.range.max) || speed_of(w.question) > 1e6);
         }});
    std::ranges::move(symptoms_of_planes(), std::back_inserter(all));
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::grid_step
