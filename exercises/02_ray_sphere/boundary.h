#pragma once

#include "arguments.h"
#include "whole_numbers.h"

#include <limits>

// Cases on a boundary, in numbers that no correct formula rounds: rays along an axis, radii and lengths of powers of
// two.

namespace raylab::grading::ray_sphere {

/// A ray whose line meets the sphere at near and far.
struct Crossing {
    Arguments given;
    double near, far;
};

/// The line passes the centre at a distance of 0, or of a radius: a tangent.
enum class Line { through_centre, tangent };

inline Crossing crossing(Dice& dice, Line line) {
    const int axis = whole(dice, 0, 2);
    const double radius = power_of_two(dice, -1, 2), length = power_of_two(dice, -1, 2), forward = sign(dice);
    const Vec3d center = whole_point(dice, -5, 5);
    const double distance = radius * whole(dice, 2, 12);
    Vec3d origin = center - along(axis, forward * distance);
    if (line == Line::tangent) origin += along(axis + whole(dice, 1, 2), sign(dice) * radius);
    const double half = line == Line::tangent ? 0 : radius;
    const RayOf<double> ray{origin, along(axis, forward * length), {0, std::numeric_limits<double>::infinity()}};
    return {{ray, {center, radius}}, (distance - half) / length, (distance + half) / length};
}

inline Arguments touching(Dice& dice) { return crossing(dice, Line::tangent).given; }

/// A range that ends, or begins, exactly at a hit: it is closed.
inline Arguments ends_at_hit(Dice& dice) {
    auto [given, near, far] = crossing(dice, Line::through_centre);
    auto& [from, to] = given.ray.range;
    switch (whole(dice, 0, 3)) {
        case 0:
            to = near;
            break;
        case 1:
            from = near;
            break;
        case 2:
            from = (near + far) / 2, to = far;
            break;
        default:
            from = far;
    }
    return given;
}

}  // namespace raylab::grading::ray_sphere
