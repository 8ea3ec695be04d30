#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include <limits>

// The cases. A part of a ray is made first, and the plane is put where the case wants it.

namespace raylab::grading::halves {

inline constexpr double endless = std::numeric_limits<double>::infinity();

/// How far the crossing of a graded case is from the range's ends, in lengths of the range.
inline constexpr double margin = 0.02;

/// A part of a ray whose plane is crossed at this share of its range: from 0 to 1 within it.
inline Arguments crossed_at(Dice& dice, double share, double sign) {
    const double begin = dice.in(0, 1) < 0.4 ? 0 : dice.in(0.1, 9), length = dice.in(0.5, 5);
    const double origin = dice.in(-9, 9), direction = sign * dice.in(0.2, 4);
    return {origin, direction, origin + (begin + share * length) * direction, {begin, begin + length}};
}

inline Arguments rising(Dice& dice) { return crossed_at(dice, dice.in(margin, 1 - margin), 1); }
inline Arguments falling(Dice& dice) { return crossed_at(dice, dice.in(margin, 1 - margin), -1); }
inline Arguments beyond(Dice& dice) {
    const double share = dice.in(1 + margin, 3);
    return crossed_at(dice, share, sign(dice));
}
inline Arguments before(Dice& dice) {
    const double share = dice.in(-3, -margin);
    return crossed_at(dice, share, sign(dice));
}

inline Arguments any_of_these(Dice& dice) {
    const double where = dice.in(0, 4);
    return where < 1 ? rising(dice) : where < 2 ? falling(dice) : where < 3 ? beyond(dice) : before(dice);
}

/// The range begins before the ray's origin, and so does the crossing lie.
inline Arguments before_the_start(Dice& dice) {
    const double begin = -dice.in(1, 9), end = dice.in(0.5, 9);
    const double origin = dice.in(-9, 9), direction = sign(dice) * dice.in(0.2, 4);
    const double t = begin * (heads(dice) ? dice.in(0.1, 0.9) : dice.in(1.1, 2));
    return {origin, direction, origin + t * direction, {begin, end}};
}

inline Arguments without_end(Dice& dice) {
    Arguments given = any_of_these(dice);
    given.range.max = endless;
    return given;
}

/// Lengths from a billionth to a billion, and the range in proportion.
inline Arguments any_length(Dice& dice) {
    Arguments given = any_of_these(dice);
    const double length = heads(dice) ? 1e-9 : 1e9;
    given.direction *= length;
    given.range = {given.range.min / length, given.range.max / length};
    return given;
}

inline Arguments parallel(Dice& dice) {
    Arguments given = any_of_these(dice);
    given.direction = heads(dice) ? 0.0 : -0.0;
    if (heads(dice)) given.range.max = endless;
    given.plane = given.origin + sign(dice) * dice.in(0.1, 9);
    return given;
}

// On a boundary, in numbers that no correct formula rounds.

inline Arguments in_whole_numbers(Dice& dice, int crossing, const Interval<double>& range) {
    const double origin = whole(dice, -20, 20), direction = sign(dice) * power_of_two(dice, -2, 3);
    return {origin, direction, origin + crossing * direction, range};
}

inline Arguments touching_the_plane(Dice& dice) {
    const int begin = whole(dice, 1, 9), end = begin + whole(dice, 1, 9);
    return in_whole_numbers(dice, heads(dice) ? begin : end, {double(begin), double(end)});
}

inline Arguments from_the_plane(Dice& dice) {
    const double end = heads(dice) ? endless : whole(dice, 1, 9);
    return in_whole_numbers(dice, 0, {0, end});
}

inline Arguments in_the_plane(Dice& dice) {
    const int begin = whole(dice, 0, 9);
    const double at = whole(dice, -20, 20), end = heads(dice) ? endless : begin + whole(dice, 1, 9);
    return {at, heads(dice) ? 0.0 : -0.0, at, {double(begin), end}};
}

/// Off one of the range's ends by a few roundings.
inline Arguments hardly_touching(Dice& dice) {
    const double share = (heads(dice) ? 1 : 0) + dice.in(-1e-15, 1e-15);
    return crossed_at(dice, share, sign(dice));
}

}  // namespace raylab::grading::halves
