#pragma once

#include "arguments.h"
#include "case.h"
#include "ground.h"
#include "whole_numbers.h"

#include <cmath>
#include <string>

// The kinds of points, lights and spheres in the cases.

namespace raylab::grading::shadow {

inline Case make(const std::string& group, Case::Kind kind, const Arguments& given) {
    Case question{group, kind, {}};
    const auto put = [&](const Vec3d& v) { question.input.insert(question.input.end(), {v.x, v.y, v.z}); };
    put(given.point);
    put(given.normal);
    put(given.light);
    question.input.push_back(given.above);
    for (const auto& sphere : given.spheres) {
        put(sphere.center);
        question.input.push_back(sphere.radius);
    }
    return question;
}

inline Case free_way(Dice& dice) {
    return make("nothing in the way", Case::Kind::graded, open_ground(dice, 1, some_distance(dice)));
}

inline Case below_surface(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.above = 1e-12 * largest_coordinate(given.point);
    return make("a point a hair under its surface", Case::Kind::graded, given);
}

inline Case between(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.spheres[0] = on_way(dice, given, dice.in(0.2, 0.8));
    return make("something between", Case::Kind::graded, given);
}

inline Case beyond_light(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.spheres[1] = on_way(dice, given, dice.in(1.3, 2.5));
    return make("something beyond the light", Case::Kind::graded, given);
}

inline Case behind_point(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.above = -1e-12 * largest_coordinate(given.point);
    given.spheres[2] = on_way(dice, given, dice.in(-0.8, -0.2));
    return make("something behind the point", Case::Kind::graded, given);
}

inline Case light_behind(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.normal = -given.normal;
    return make("a light behind the surface", Case::Kind::graded, given);
}

inline Case close_by(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = dice.in(1e-4, 4e-4);
    // Not larger than the gap, so that the segment to the light soon leaves it behind.
    const double radius = gap * dice.in(0.2, 0.8);
    given.spheres[3] = {given.point + to_light * (gap + radius), radius};
    given.above = -1e-12 * largest_coordinate(given.point);
    return make("something very close", Case::Kind::graded, given);
}

inline Case anything(Dice& dice, const std::string& group, double scale) {
    auto given = open_ground(dice, scale, dice.in(2, 10));
    for (std::size_t i = 0; i < 3; ++i) given.spheres[i] = on_way(dice, given, dice.in(0.1, 2));
    for (auto& sphere : given.spheres)
        if (dice.in(0, 1) < 0.6) sphere.radius = 0;
    return make(group, Case::Kind::graded, given);
}

inline Case under_large(Dice& dice) {
    auto given = open_ground(dice, 1e5, dice.in(2, 10));
    given.above = 1e-12 * largest_coordinate(given.point);
    return make("a hundred kilometres, a hair under the surface", Case::Kind::graded, given);
}

inline Case close_in_small(Dice& dice) {
    auto given = open_ground(dice, 1e-4, dice.in(2, 10));
    given.spheres[0] = on_way(dice, given, dice.in(0.2, 0.6));
    return make("a tenth of a millimetre, something between", Case::Kind::graded, given);
}

/// What is close in a small scene: an offset that is small in a room passes over it.
inline Case very_close_in_small(Dice& dice) {
    auto given = open_ground(dice, 1e-4, dice.in(2, 10));
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = 1e-4 * dice.in(1e-4, 4e-4), radius = gap * dice.in(0.2, 0.8);
    given.spheres[3] = {given.point + to_light * (gap + radius), radius};
    given.above = -1e-12 * largest_coordinate(given.point);
    return make("a tenth of a millimetre, something very close", Case::Kind::graded, given);
}

/// All of a small scene, a hundred kilometres off: a hair is as long as the coordinates are large, and nothing else is.
inline Case far_from_origin(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d away = dice.direction() * 1e5;
    given.point += away;
    given.light += away;
    given.above = (heads(dice) ? 1e-12 : -1e-12) * largest_coordinate(given.point);
    if (heads(dice)) given.spheres[0] = on_way(dice, given, dice.in(0.3, 0.7));
    return make("a small scene far from the origin", Case::Kind::graded, given);
}

/// The light is a hundred kilometres away, and a hair is as long as that says; what casts a shadow, a few metres.
inline Case far_light(Dice& dice) {
    auto given = open_ground(dice, 1, 1e5);
    given.above = (heads(dice) ? 1e-12 : -1e-12) * largest_coordinate(given.light);
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = dice.in(2, 8), radius = gap * dice.in(0.2, 0.8);
    if (heads(dice)) given.spheres[1] = {given.point + to_light * (gap + radius), radius};
    return make("a near thing, a far light", Case::Kind::graded, given);
}

inline Case before_light(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d way = given.light - given.point;
    const double radius = 0.01 * glm::length(way) * dice.in(0.1, 0.4);
    given.spheres[2] = {given.light - way * dice.in(0.005, 0.008), radius};
    return make("something just before the light", Case::Kind::graded, given);
}

/// So close to the light that no share of the way, and no fixed length, may be left out; in a scene of some metres or
/// of some tenths of a millimetre.
inline Case right_before_light(Dice& dice) {
    auto given = open_ground(dice, heads(dice) ? 1 : 1e-4, dice.in(2, 10));
    const double share = std::exp(dice.in(std::log(3e-6), std::log(1e-3)));
    const Vec3d way = given.light - given.point;
    given.spheres[2] = {given.light - way * share, glm::length(way) * share * dice.in(0.3, 0.6)};
    return make("something right before the light", Case::Kind::graded, given);
}

/// The way to the light is as short as it may be where coordinates are so large, and the hair as long: an offset in
/// proportion to the way is no longer than the hair.
inline Case short_way_far_off(Dice& dice) {
    auto given = open_ground(dice, 1, 1);
    const Vec3d to_light = glm::normalize(given.light - given.point), away = dice.direction() * 1e5;
    given.point += away;
    const double largest = largest_coordinate(given.point);
    given.light = given.point + to_light * (1.00002e-5 * largest);
    given.above = 1e-12 * largest;
    return make("a short way far from the origin, a hair under the surface", Case::Kind::graded, given);
}

/// The light is less than a degree above the surface. What is lit lies a hair under it, what is not, on either side.
inline Case low_light(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d along = glm::normalize(cross(given.normal, dice.direction()));
    const double rise = std::exp(dice.in(std::log(0.003), std::log(0.015)));
    given.light = given.point + (along + rise * given.normal) * dice.in(2, 10);
    given.above = 1e-12 * largest_coordinate(given.point);
    if (heads(dice)) {
        given.spheres[3] = on_way(dice, given, dice.in(0.3, 0.7));
        given.above *= sign(dice);
    }
    return make("a light low over the surface", Case::Kind::graded, given);
}

inline Case light_on_ball(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d out = glm::normalize(given.light - given.point + dice.direction());
    given.spheres[0] = {given.light + out * 0.5, 0.5};
    return make("a light that touches a ball", Case::Kind::adversarial, given);
}

inline Case grazing(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d way = given.light - given.point;
    const Vec3d aside = glm::normalize(cross(way, dice.direction()));
    given.spheres[0] = {given.point + way * 0.5 + aside, 1 + (dice.in(0, 1) < 0.5 ? -1e-9 : 1e-9)};
    return make("a way that grazes a ball", Case::Kind::adversarial, given);
}

}  // namespace raylab::grading::shadow
