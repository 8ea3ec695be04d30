#pragma once

#include "arguments.h"
#include "whole_numbers.h"

#include <limits>

// Cases on a boundary, in numbers that no correct formula rounds: rays from a cell's middle through its edges and
// corners, and ranges that end on a face.

namespace raylab::grading::grid_step {

/// From some sides before the middle of an inner cell, in steps of half a side along each of these axes.
inline Arguments from_middle(Dice& dice, const Vec3d& steps) {
    const double side = power_of_two(dice, -1, 2);
    const UniformGrid grid{
        whole_point(dice, -9, 9), side, {whole(dice, 3, 12), whole(dice, 3, 12), whole(dice, 3, 12)}};
    Cell cell{};
    Vec3d middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        cell[axis] = whole(dice, 1, grid.cells[axis] - 2);
        middle[i] = grid.low[i] + (cell[axis] + 0.5) * side;
    }
    const Vec3d direction = steps * (side * power_of_two(dice, -2, 2));
    return {{middle - direction * double(whole(dice, 0, 3)), direction, {0, std::numeric_limits<double>::infinity()}},
            grid,
            cell};
}

/// Exactly through an edge or a corner, where two or three faces are reached at the same t: each of them will do.
inline Arguments exactly_through_edge(Dice& dice) {
    Vec3d steps{sign(dice), sign(dice), sign(dice)};
    if (const int flat = whole(dice, 0, 3); flat < 3) steps[flat] = 0;  // 3: a corner
    return from_middle(dice, steps);
}

/// The range is over where the ray reaches the face: not before.
inline Arguments ends_on_face(Dice& dice) {
    const int axis = whole(dice, 0, 2);
    Arguments given = from_middle(dice, along(axis, sign(dice)));
    const auto i = static_cast<std::size_t>(axis);
    const double speed = given.ray.direction[axis];
    const double face = given.grid.low[axis] + (given.cell[i] + (speed > 0 ? 1 : 0)) * given.grid.side;
    given.ray.range.max = (face - given.ray.origin[axis]) / speed;
    return given;
}

}  // namespace raylab::grading::grid_step
