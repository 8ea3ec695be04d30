#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>

// Where the point of an answer lies.

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

/// The t at which the ray leaves the cube.
inline double leaves_at(const Case& question) {
    const auto given = of(question);
    const int axis = across(question);
    return (exit_point(question)[axis] - given.origin[axis]) / given.direction[axis];
}

/// How fast the ray goes across that face, in metres while t grows by one.
inline double speed_across(const Case& question) { return std::abs(of(question).direction[across(question)]); }

/// How far the answer lies beyond the face, in smallest cells: negative before it.
inline double beyond(const WrongAnswer& w) {
    const auto given = of(w.question);
    const int axis = across(w.question);
    const double off = w.given[static_cast<std::size_t>(axis)] - exit_point(w.question)[axis];
    return (given.direction[axis] > 0 ? off : -off) / given.smallest;
}

/// Whether the answer is at this place, within so many smallest cells, but for the axis that the ray leaves across.
inline bool is_beside_place(const WrongAnswer& w, const Vec3d& place, double cells) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != across(w.question) &&
            std::abs(w.given[static_cast<std::size_t>(axis)] - place[axis]) > cells * of(w.question).smallest)
            return false;
    return true;
}

/// Whether it is where the ray is after this many times its way to the exit.
inline bool is_beside_at(const WrongAnswer& w, double times) {
    const Vec3d origin = of(w.question).origin;
    return is_beside_place(w, origin + times * (exit_point(w.question) - origin), 0.01);
}

/// Whether the point is where the ray leaves, on the other two axes, up to this many smallest cells.
inline bool is_beside(const WrongAnswer& w, double cells) { return is_beside_place(w, exit_point(w.question), cells); }

/// Whether so many smallest cells beyond the face are no place in the first one: past it, or as good as on the face.
inline bool leaves_the_first_cell(double cells) { return cells > 1 || cells < 1e-6; }

/// How far along the ray the answer lies beyond the place where it leaves.
inline double length_beyond(const WrongAnswer& w) {
    const Vec3d way = Vec3d{w.given[0], w.given[1], w.given[2]} - exit_point(w.question);
    return dot(way, glm::normalize(of(w.question).direction));
}

inline bool lies_on_the_ray(const WrongAnswer& w) {
    const auto given = of(w.question);
    const Vec3d way = Vec3d{w.given[0], w.given[1], w.given[2]} - given.origin;
    const double along = glm::length(way) * glm::length(given.direction);
    return along - dot(way, given.direction) < 1e-9 * along;
}

/// Whether the answer lies straight across the face from where the ray leaves, and not along the ray, as far as the two
/// can be told apart.
inline bool is_straight_across(const WrongAnswer& w) {
    const auto given = of(w.question);
    const int axis = across(w.question);
    const Vec3d exit = exit_point(w.question);
    const double step = std::abs(w.given[static_cast<std::size_t>(axis)] - exit[axis]);
    double along_the_ray = 0, aside = 0;
    for (int other = 0; other < 3; ++other) {
        if (other == axis) continue;
        along_the_ray = std::max(along_the_ray, step * std::abs(given.direction[other] / given.direction[axis]));
        aside = std::max(aside, std::abs(w.given[static_cast<std::size_t>(other)] - exit[other]));
    }
    return aside < along_the_ray / 2;
}

inline bool is_one_of(double x, std::initializer_list<double> values, double rounding = 0) {
    return std::ranges::any_of(values, [&](double value) { return std::abs(x - value) < 1e-3 * value + rounding; });
}

/// By how many smallest cells the answer lies beside the right one along an axis: 0 in it, 1 in the next one up.
inline double cells_off(const WrongAnswer& w, int axis) {
    const auto given = of(w.question);
    const auto i = static_cast<std::size_t>(axis);
    return std::floor((w.given[i] - truth(given).low[i]) / given.smallest);
}

/// Whether the answer lies in a neighbour of the right cell: the next one along one of the other axes, or along both.
/// By cutting off digits that is so only where the place is negative.
inline bool is_a_cell_beside(const WrongAnswer& w, bool only_if_negative) {
    if (lies_on_the_ray(w)) return false;
    bool seen = false;
    for (int axis = 0; axis < 3; ++axis) {
        const double off = cells_off(w, axis);
        if (off == 0) continue;
        // Who counts cells downward has the next one down, and may give its middle.
        const double in_cell = w.given[static_cast<std::size_t>(axis)] / of(w.question).smallest - 0.5;
        const bool is_down = off == -1 && !only_if_negative && std::abs(in_cell - std::round(in_cell)) < 1e-6;
        if (!(off == 1 || is_down) || axis == across(w.question)) return false;
        if (only_if_negative && exit_point(w.question)[axis] >= 0) return false;
        seen = true;
    }
    return seen;
}
inline bool leaves_at_negative_place(const Case& question) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != across(question) && exit_point(question)[axis] < 0) return true;
    return false;
}

enum class Side { ahead, behind };

/// Whether the answer lies where the ray reaches this axis' plane on that side of the cube, or near it, or at the place
/// of the cube's face that is nearest to that: someone may keep the point on the face.
inline bool lies_on(const WrongAnswer& w, int axis, Side side) {
    const auto given = of(w.question);
    const bool high = (given.direction[axis] > 0) == (side == Side::ahead);
    const double plane = given.cube.low[axis] + (high ? given.cube.side : 0);
    const Vec3d at = given.origin + (plane - given.origin[axis]) / given.direction[axis] * given.direction;
    for (int other = 0; other < 3; ++other) {
        const double room = (other == axis ? 1 : 1e-6) * given.smallest;
        const double low = given.cube.low[other], mine = w.given[static_cast<std::size_t>(other)];
        const double kept = other == axis ? at[other] : std::clamp(at[other], low, low + given.cube.side);
        if (std::abs(mine - at[other]) > room && std::abs(mine - kept) > room) return false;
    }
    return true;
}

inline bool is_parallel(const Case& question) {
    const auto& d = of(question).direction;
    return d.x == 0 || d.y == 0 || d.z == 0;
}
inline bool is_short(const Case& question) { return glm::length(of(question).direction) < 1e-6; }
inline bool has_tiny_cells(const Case& question) { return of(question).smallest < 1e-5; }
inline int moving_axes(const Case& question) {
    const auto& d = of(question).direction;
    return (d.x != 0) + (d.y != 0) + (d.z != 0);
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

/// Whether the point lies beyond the face, where the origin is along the other axes, or as far as the face goes.
inline bool lies_beside_the_origin(const WrongAnswer& w) {
    const auto given = of(w.question);
    const Vec3d high = given.cube.low + Vec3d(given.cube.side);
    return beyond(w) > 0 && !is_beside(w, 0.01) &&
           (is_beside_place(w, given.origin, 1) ||
            is_beside_place(w, glm::clamp(given.origin, given.cube.low, high), 1));
}

}  // namespace raylab::grading::next_cell
