#pragma once

#include "arguments.h"
#include "dice.h"
#include "whole_numbers.h"

#include <limits>

// The kinds of rays and boxes in the cases.

namespace raylab::grading::boxes {

struct Question {
    Arguments given;
    // Exact: no method rounds them, so that they need no margin.
    enum class Numbers { any, exact } numbers = Numbers::any;
};

inline Arguments any_box(Dice& dice) {
    const Vec3d low = dice.point(-2, 1);
    return {{{}, {}, {0, 100}}, low, low + dice.point(0.3, 2)};
}

inline Vec3d inside(Dice& dice, const Arguments& given) {
    const Vec3d share = dice.point(0.1, 0.9);
    return given.low + (given.high - given.low) * share;
}

inline Question through(Dice& dice) {
    Arguments given = any_box(dice);
    const Vec3d point = inside(dice, given);
    given.ray.origin = point + dice.direction() * dice.in(4, 9);
    given.ray.direction = (point - given.ray.origin) * dice.in(0.1, 2);
    return {given};
}

inline Question anywhere(Dice& dice) {
    Arguments given = any_box(dice);
    given.ray.origin = dice.point(-5, 5);
    given.ray.direction = dice.point(-1.5, 1.5) - given.ray.origin;
    return {given};
}

inline Question from_inside(Dice& dice) {
    Arguments given = any_box(dice);
    given.ray = {inside(dice, given), dice.direction(), {0, 100}};
    return {given};
}

inline Question behind(Dice& dice) {
    Question question = through(dice);
    question.given.ray.direction = -question.given.ray.direction;
    return question;
}

inline Question too_short(Dice& dice) {
    Question question = through(dice);
    question.given.ray.direction = glm::normalize(question.given.ray.direction);
    question.given.ray.range.max = dice.in(0.3, 1);
    return question;
}

// A range that begins where the ray is inside, or behind the box: the end of the way through the middle is known.
inline Question begins_late(Dice& dice) {
    Question question = from_inside(dice);
    RayOf<double>& ray = question.given.ray;
    ray.origin -= ray.direction * 5.0;
    ray.range.min = dice.in(0, 1) < 0.5 ? 5 : dice.in(9, 12);
    return question;
}

// The start is in the box, and the range begins before it, or beyond the box: where t is 0 says nothing of that.
inline Question starts_elsewhere(Dice& dice) {
    Question question = from_inside(dice);
    question.given.ray.range = {heads(dice) ? dice.in(-9, -5) : dice.in(5, 9), 100};
    return question;
}

// A range that begins before the ray's start, where the box is behind it.
inline Question begins_before_start(Dice& dice) {
    Question question = behind(dice);
    RayOf<double>& ray = question.given.ray;
    ray.direction = glm::normalize(ray.direction);
    ray.range = {-100, heads(dice) ? -0.5 : 100};
    return question;
}

inline Question endless(Dice& dice) {
    Question question = heads(dice) ? through(dice) : anywhere(dice);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    question.given.ray.range = {heads(dice) ? 0 : -infinity, infinity};
    return question;
}

// Two coordinates of the direction are 0, or -0; the ray is between the planes or beside them.
inline Question along_axis(Dice& dice) {
    Arguments given = any_box(dice);
    const int along = whole(dice, 0, 2);
    given.ray.origin = inside(dice, given);
    if (dice.in(0, 1) < 0.5) given.ray.origin[(along + whole(dice, 1, 2)) % 3] += dice.in(0, 1) < 0.5 ? 4 : -4;
    for (int axis = 0; axis < 3; ++axis) given.ray.direction[axis] = dice.in(0, 1) < 0.5 ? 0.0 : -0.0;
    const double forward = dice.in(0, 1) < 0.5 ? 1 : -1;
    given.ray.direction[along] = forward;
    given.ray.origin[along] = -7 * forward;
    return {given};
}

// Integers and powers of two, so that nothing is rounded.
inline Arguments whole_box(Dice& dice) {
    Arguments given{{{}, {}, {0, 100}}, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        given.low[axis] = whole(dice, -3, 2);
        given.high[axis] = given.low[axis] + whole(dice, 1, 3);
    }
    return given;
}

inline Question in_face(Dice& dice) {
    Arguments given = whole_box(dice);
    const int along = whole(dice, 0, 2), across = (along + whole(dice, 1, 2)) % 3;
    for (int axis = 0; axis < 3; ++axis) given.ray.direction[axis] = dice.in(0, 1) < 0.5 ? 0.0 : -0.0;
    given.ray.origin = (given.low + given.high) / 2.0;
    given.ray.origin[across] = dice.in(0, 1) < 0.5 ? given.low[across] : given.high[across];
    const double forward = (dice.in(0, 1) < 0.5 ? 1 : -1) * (dice.in(0, 1) < 0.5 ? 1 : 0.5);
    given.ray.direction[along] = forward;
    given.ray.origin[along] = forward < 0 ? 8 : -8;
    return {given, Question::Numbers::exact};
}

// A range that ends where the box begins, or begins where it ends: range and box are closed.
inline Question ends_at_face(Dice& dice) {
    Arguments given = whole_box(dice);
    const int axis = whole(dice, 0, 2);
    const double forward = sign(dice), length = power_of_two(dice, -1, 1);
    given.ray.origin = (given.low + given.high) / 2.0;
    given.ray.direction = along(axis, forward * length);
    const double half = (given.high[axis] - given.low[axis]) / 2 / length;
    given.ray.range = heads(dice) ? Interval<double>{-100, -half} : Interval<double>{half, 100};
    return {given, Question::Numbers::exact};
}

inline Question flat(Dice& dice) {
    Arguments given = whole_box(dice);
    const int across = whole(dice, 0, 2), along = (across + 1) % 3;
    given.high[across] = given.low[across];
    given.ray.origin = (given.low + given.high) / 2.0;
    given.ray.direction = {0, 0, 0};
    if (dice.in(0, 1) < 0.5) {  // through it at an angle
        given.ray.origin[across] -= 4;
        given.ray.direction[across] = 0.5;
        given.ray.direction[along] = dice.in(0, 1) < 0.5 ? 0.03125 : -0.03125;
    } else {  // in its plane
        given.ray.origin[along] = 8;
        given.ray.direction[along] = -1;
    }
    return {given, Question::Numbers::exact};
}

inline Question any_length(Dice& dice) {
    Question question = dice.in(0, 1) < 0.5 ? through(dice) : anywhere(dice);
    const double length = dice.in(0, 1) < 0.5 ? 1e-9 : 1e9;
    question.given.ray.direction *= length;
    question.given.ray.range.max = 1e3 / length;
    return question;
}

inline Question at_corner(Dice& dice) {
    Arguments given = any_box(dice);
    Vec3d corner{};
    for (int axis = 0; axis < 3; ++axis) corner[axis] = dice.in(0, 1) < 0.5 ? given.low[axis] : given.high[axis];
    given.ray.origin = corner + dice.direction() * 6.0;
    given.ray.direction = corner - given.ray.origin;
    return {given};
}

inline Question far_in_face(Dice& dice) {
    Question question = in_face(dice);
    const Vec3d away = dice.point(-1e9, 1e9);
    question.given.low += away;
    question.given.high += away;
    question.given.ray.origin += away;
    return question;
}

}  // namespace raylab::grading::boxes
