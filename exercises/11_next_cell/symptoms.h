#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>

// What wrong answers to this exercise have in common. A right answer is any point of a cell, so that they are told by
// where the point lies.

namespace raylab::grading::next_cell {

inline Arguments of(const Case& question) { return arguments(question.input); }
inline int across(const Case& question) { return truth(of(question)).axis; }

/// Where the ray leaves the cube: on its face.
inline Vec3d exit_point(const Case& question) {
    const auto given = of(question);
    const int axis = across(question);
    const double plane = given.direction[axis] > 0 ? given.cube.low[axis] + given.cube.side : given.cube.low[axis];
    return given.origin + (plane - given.origin[axis]) / given.direction[axis] * given.direction;
}

/// How far the answer lies beyond the face, in smallest cells: negative before it.
inline double beyond(const WrongAnswer& w) {
    const auto given = of(w.question);
    const int axis = across(w.question);
    const double off = w.given[static_cast<std::size_t>(axis)] - exit_point(w.question)[axis];
    return (given.direction[axis] > 0 ? off : -off) / given.smallest;
}

/// Whether the point is where the ray leaves, on the other two axes, up to this many smallest cells.
inline bool is_beside(const WrongAnswer& w, double cells) {
    const Vec3d exit = exit_point(w.question);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != across(w.question) &&
            std::abs(w.given[static_cast<std::size_t>(axis)] - exit[axis]) > cells * of(w.question).smallest)
            return false;
    return true;
}

enum class Side { ahead, behind };

/// Whether the answer lies where the ray reaches this axis' plane on that side of the cube, or near it.
inline bool lies_on(const WrongAnswer& w, int axis, Side side) {
    const auto given = of(w.question);
    const bool high = (given.direction[axis] > 0) == (side == Side::ahead);
    const double plane = given.cube.low[axis] + (high ? given.cube.side : 0);
    const Vec3d at = given.origin + (plane - given.origin[axis]) / given.direction[axis] * given.direction;
    for (int other = 0; other < 3; ++other) {
        const double room = (other == axis ? 1 : 1e-6) * given.smallest;
        if (std::abs(w.given[static_cast<std::size_t>(other)] - at[other]) > room) return false;
    }
    return true;
}

inline bool is_parallel(const Case& question) {
    const auto& d = of(question).direction;
    return d.x == 0 || d.y == 0 || d.z == 0;
}
inline bool goes_backward(const Case& question) {
    const auto& d = of(question).direction;
    return d.x < 0 || d.y < 0 || d.z < 0;
}
inline bool is_inside_cube(const WrongAnswer& w) {
    const auto cube = of(w.question).cube;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = w.given[static_cast<std::size_t>(axis)];
        if (!(x >= cube.low[axis] && x <= cube.low[axis] + cube.side)) return false;
    }
    return true;
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"zero_divided", "a coordinate of the direction is 0",
         [](const WrongAnswer& w) { return is_parallel(w.question); }, is_parallel});
    add({"on_the_face", "the point lies on the face, or a rounding error beside it",
         [](const WrongAnswer& w) { return std::abs(beyond(w)) < 1e-6 && is_beside(w, 1e-3); }});
    add({"own_size", "the point is right beside, and as far beyond the face as this cell's size says",
         [](const WrongAnswer& w) {
             return beyond(w) > 1 - 1e-6 && is_beside(w, 0.01) && of(w.question).cube.side > of(w.question).smallest;
         }});
    add({"wrong_way", "the point is right beside, and before the face: still in this cell",
         [](const WrongAnswer& w) { return beyond(w) < -1e-6 && beyond(w) > -1 && is_beside(w, 0.01); }});
    add({"all_axes", "the point is beyond the face, and moved along the other axes, too", [](const WrongAnswer& w) {
             if (!(beyond(w) > 0 && beyond(w) < 1)) return false;
             const Vec3d exit = exit_point(w.question);
             for (int axis = 0; axis < 3; ++axis) {
                 const double off =
                     std::abs(w.given[static_cast<std::size_t>(axis)] - exit[axis]) / of(w.question).smallest;
                 if (axis != across(w.question) && off > 1.01) return false;
             }
             return true;
         }});
    add({"from_the_middle", "the point is beyond the face, in its middle", [](const WrongAnswer& w) {
             const auto cube = of(w.question).cube;
             for (int axis = 0; axis < 3; ++axis)
                 if (axis != across(w.question) && std::abs(w.given[static_cast<std::size_t>(axis)] - cube.low[axis] -
                                                            cube.side / 2) > 1e-6 * cube.side)
                     return false;
             return beyond(w) > 0;
         }});
    add({"near_plane", "the point is where the ray comes in through one of the faces behind it",
         [](const WrongAnswer& w) {
             for (int axis = 0; axis < 3; ++axis)
                 if (of(w.question).direction[axis] != 0 && lies_on(w, axis, Side::behind)) return true;
             return false;
         }});
    add({"fixed_step", "the cells are of another size than 1, or about 1",
         [](const WrongAnswer& w) { return of(w.question).smallest < 0.2 || of(w.question).smallest > 2; }});
    add({"forward_only", "a coordinate of the direction is negative",
         [](const WrongAnswer& w) { return goes_backward(w.question); }});
    add({"unit_direction", "the direction is not of length 1", [](const WrongAnswer& w) {
             const auto [axis, low, margin, between] = truth(of(w.question));
             const bool is_on_border = between[0] || between[1] || between[2];
             return !is_on_border && !is_beside(w, 0.01) && std::abs(glm::length(of(w.question).direction) - 1) > 1e-6;
         }});
    add({"half_cell_along", "the point lies on the ray, too far along it", [](const WrongAnswer& w) {
             const auto given = of(w.question);
             const Vec3d way = Vec3d{w.given[0], w.given[1], w.given[2]} - given.origin;
             const double along = glm::length(way) * glm::length(given.direction);
             return beyond(w) > 0 && along - dot(way, given.direction) < 1e-9 * along;
         }});
    add({"last_plane", "the point is where the ray leaves through a face that it reaches later",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             for (int axis = 0; axis < 3; ++axis)
                 if (axis != across(w.question) && given.direction[axis] != 0 && lies_on(w, axis, Side::ahead))
                     return true;
             return false;
         }});
    add({"stays", "the point lies in the cell that the ray is to leave", is_inside_cube});
    return all;
}

}  // namespace raylab::grading::next_cell
