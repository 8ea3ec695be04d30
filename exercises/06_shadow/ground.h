#pragma once

#include "arguments.h"
#include "dice.h"

#include "raylab/geometry/scaled_to_largest_one.h"

#include <algorithm>
#include <cmath>

// The parts of cases: a point, a light in front of it, and objects near the segment between them.

namespace raylab::grading::shadow {

/// A point, a light at some distance before it, both times `scale`, and rounding as it comes.
inline Arguments open_ground(Dice& dice, double scale, double distance) {
    Arguments given{};
    given.point = dice.point(-5, 5) * scale;
    given.normal = dice.direction();
    Vec3d to_light = dice.direction();
    while (std::abs(dot(to_light, given.normal)) < 0.2) to_light = dice.direction();
    if (dot(to_light, given.normal) < 0) to_light = -to_light;
    given.light = given.point + to_light * (distance * scale);
    given.above = dice.in(-1e-12, 1e-12) * std::max(largest_coordinate(given.point), largest_coordinate(given.light));
    return given;
}

/// A sphere with its center at a share of the way to the light, slightly beside it, whose radius is smaller than its
/// distance from both ends.
inline SphereOf<double> on_way(Dice& dice, const Arguments& given, double share) {
    const Vec3d way = given.light - given.point;
    const double room = glm::length(way) * std::min(std::abs(share), std::abs(1 - share));
    const double radius = room * dice.in(0.3, 0.6);
    return {given.point + way * share + dice.direction() * (radius * dice.in(0, 0.6)), radius};
}

/// From a few centimetres to ten metres, in a scene of some metres.
inline double some_distance(Dice& dice) { return dice.in(0, 1) < 0.5 ? dice.in(0.05, 0.5) : dice.in(2, 10); }

}  // namespace raylab::grading::shadow
