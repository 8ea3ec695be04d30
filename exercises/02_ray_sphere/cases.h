#pragma once

#include "arguments.h"
#include "dice.h"
#include "whole_numbers.h"

#include <cmath>
#include <limits>

// The kinds of rays and spheres in the cases that keep a margin from every decision.

namespace raylab::grading::ray_sphere {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline SphereOf<double> some_sphere(Dice& dice) {
    return {as_floats(dice.point(-3, 3)), 0x1p-8 * std::round(dice.in(64, 512))};
}

/// A ray from `away` radii, aimed at a point `reach` radii from the centre.
inline Arguments aimed(Dice& dice, double reach, double away, double length) {
    const auto sphere = some_sphere(dice);
    const Vec3d out = dice.direction();
    const Vec3d origin = as_floats(sphere.center + out * (sphere.radius * away));
    const Vec3d side = glm::normalize(cross(out, dice.direction()));
    const Vec3d target = sphere.center + side * (sphere.radius * reach);
    return {{origin, as_floats((target - origin) * (length / glm::length(target - origin))), {0, infinity}}, sphere};
}

inline Arguments in_front(Dice& dice) {
    const double reach = dice.in(0, 0.95);
    return aimed(dice, reach, dice.in(2, 6), 1);
}

/// From nearby a ray toward a point beside the sphere may still hit it: such draws are made again.
inline Arguments passing_by(Dice& dice) {
    constexpr double clearance = 1.05;  // radii between the line and the centre
    for (;;) {
        const double reach = dice.in(1.1, 3), away = dice.in(2, 6);
        if (reach * away / std::hypot(reach, away) >= clearance) return aimed(dice, reach, away, 1);
    }
}

inline Arguments behind(Dice& dice) {
    auto given = in_front(dice);
    given.ray.direction = -given.ray.direction;
    return given;
}

inline Arguments from_inside(Dice& dice) {
    const auto sphere = some_sphere(dice);
    const Vec3d origin = as_floats(sphere.center + dice.direction() * (sphere.radius * dice.in(0, 0.9)));
    const Vec3d direction = dice.direction();
    return {{origin, as_floats(direction * dice.in(0.5, 2)), {0, infinity}}, sphere};
}

inline Arguments of_any_length(Dice& dice) {
    const double reach = dice.in(0, 0.95), away = dice.in(2, 6);
    return aimed(dice, reach, away, dice.in(0.1, 20));
}

/// The t at which the line is nearest to the centre.
inline double middle_of(const Arguments& given) {
    const auto& [o, d, range] = given.ray;
    return dot(given.sphere.center - o, d) / dot(d, d);
}

/// A range that leaves out the first intersection, or both.
inline Arguments cut(Dice& dice, const Arguments& from) {
    auto given = from;
    const double middle = middle_of(given);
    if (heads(dice))
        given.ray.range.min = middle;
    else
        given.ray.range.max = middle / 4;
    return given;
}
inline Arguments cut_unit(Dice& dice) { return cut(dice, in_front(dice)); }
inline Arguments cut_any_length(Dice& dice) { return cut(dice, of_any_length(dice)); }

/// A range that ends between the intersections, before the middle or after it, or has neither of them.
inline Arguments ends_inside(Dice& dice, double length) {
    auto given = aimed(dice, dice.in(0, 0.7), 4, length);
    const double middle = middle_of(given), quarter = 0.25 * given.sphere.radius / length;
    given.ray.range.max = heads(dice) ? middle - quarter : middle + quarter;
    if (heads(dice)) given.ray.range = {middle - quarter, middle + quarter};
    return given;
}
inline Arguments ends_inside_unit(Dice& dice) { return ends_inside(dice, 1); }
inline Arguments ends_inside_any_length(Dice& dice) { return ends_inside(dice, dice.in(0.1, 20)); }

/// A range that begins before the ray's start: what is behind it counts.
inline Arguments begins_before_start(Dice& dice) {
    auto given = behind(dice);
    given.ray.range = heads(dice) ? Interval<double>{-100, 100} : Interval<double>{-infinity, infinity};
    return given;
}

inline Arguments scaled(Arguments given, double by) {
    given.ray.origin *= by;
    given.sphere.center *= by;
    given.sphere.radius *= by;
    return given;
}

inline Arguments tiny(Dice& dice) { return scaled(in_front(dice), 0x1p-16); }

inline Arguments far_off(Dice& dice) {
    const double reach = dice.in(0, 0.5);
    return scaled(aimed(dice, reach, dice.in(300, 600), 1), 32);
}

/// A sphere as floor, from a height of one to three metres.
inline Arguments underfoot(Dice& dice) {
    const double radius = dice.in(1e3, 1e4);
    const Vec3d up = dice.direction();
    const Vec3d origin = as_floats(dice.point(-3, 3));
    const Vec3d down = as_floats(-up + 0.5 * glm::normalize(cross(up, dice.direction())));
    return {{origin, down, {0, infinity}}, {origin - up * (radius + dice.in(1, 3)), radius}};
}

}  // namespace raylab::grading::ray_sphere
