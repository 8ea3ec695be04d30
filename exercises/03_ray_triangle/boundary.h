#pragma once

#include "arguments.h"
#include "whole_numbers.h"

#include <limits>
#include <utility>

// Cases on a boundary, in numbers that no correct formula rounds: triangles across an axis whose two sides at the right
// angle are powers of two, and rays along that axis.

namespace raylab::grading::ray_triangle {

/// Such a ray goes through the triangle's plane at t, in this point of the triangle.
struct Crossing {
    Arguments given;
    double t;
};

inline Crossing crossing(Dice& dice, double u, double v) {
    const int axis = whole(dice, 0, 2);
    const Vec3d corner = whole_point(dice, -5, 5);
    Vec3d one = along(axis + 1, sign(dice) * power_of_two(dice, 0, 3));
    Vec3d other = along(axis + 2, sign(dice) * power_of_two(dice, 0, 3));
    if (heads(dice)) std::swap(one, other);
    const double length = power_of_two(dice, -1, 2), distance = whole(dice, 1, 20), forward = sign(dice);
    const Vec3d origin = corner + u * one + v * other - along(axis, forward * distance);
    return {{{origin, along(axis, forward * length), {0, std::numeric_limits<double>::infinity()}},
             {corner, corner + one, corner + other}},
            distance / length};
}

/// Through an edge, or a vertex.
inline Arguments on_edge(Dice& dice) {
    const double place = whole(dice, 0, 4) / 4.0;  // of five, two are vertices
    switch (whole(dice, 0, 2)) {
        case 0:
            return crossing(dice, place, 0).given;
        case 1:
            return crossing(dice, 0, place).given;
        default:
            return crossing(dice, place, 1 - place).given;
    }
}

/// On the straight line of an edge, beyond one of its vertices: one weight is 0, another one negative.
inline Arguments beyond_a_vertex(Dice& dice) {
    const double out = whole(dice, 1, 8) / 4.0, place = heads(dice) ? -out : 1 + out;
    switch (whole(dice, 0, 2)) {
        case 0:
            return crossing(dice, place, 0).given;
        case 1:
            return crossing(dice, 0, place).given;
        default:
            return crossing(dice, place, 1 - place).given;
    }
}

/// A range that ends, or begins, exactly at the hit: it is closed.
inline Arguments ends_at_hit(Dice& dice) {
    auto [given, t] = crossing(dice, 0.25, 0.5);
    (heads(dice) ? given.ray.range.min : given.ray.range.max) = t;
    return given;
}

}  // namespace raylab::grading::ray_triangle
