#pragma once

#include "arguments.h"

#include <cmath>
#include <limits>
#include <optional>

// The truth, by points and not by slabs: the first of a ray's points in a box is the one at which it starts, or lies in
// the plane of a face and between the others. It is computed in long double.

namespace raylab::grading::boxes {

using Exact = long double;

inline bool between(const Arguments& given, int axis, Exact t) {
    const Exact at = static_cast<Exact>(given.ray.origin[axis]) + t * static_cast<Exact>(given.ray.direction[axis]);
    return at >= static_cast<Exact>(given.low[axis]) && at <= static_cast<Exact>(given.high[axis]);
}

/// Whether the point at t is between the planes of all axes except `known`, in whose plane it lies (3: no such axis).
inline bool is_inside(const Arguments& given, Exact t, int known) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != known && !between(given, axis, t)) return false;
    return true;
}

inline std::optional<Exact> first_inside(const Arguments& given) {
    const Exact start = given.ray.range.min, end = given.ray.range.max;
    std::optional<Exact> first;
    const auto offer = [&](Exact t, int known) {
        if (t >= start && t <= end && (!first || t < *first) && is_inside(given, t, known)) first = t;
    };
    offer(start, 3);
    for (int axis = 0; axis < 3; ++axis) {
        if (given.ray.direction[axis] == 0) continue;
        for (const double plane : {given.low[axis], given.high[axis]})
            offer((static_cast<Exact>(plane) - static_cast<Exact>(given.ray.origin[axis])) /
                      static_cast<Exact>(given.ray.direction[axis]),
                  axis);
    }
    return first;
}

/// Whether the answer is the same for a slightly larger or smaller box, and for a slightly longer or shorter range.
inline bool keeps_margin(const Arguments& given) {
    const bool truth = first_inside(given).has_value();
    const double size = glm::length(given.low - given.ray.origin) + glm::length(given.high - given.ray.origin);
    const double length = glm::length(given.ray.direction);
    for (const double by : {-1e-6 * size, 1e-6 * size}) {
        Arguments other = given;
        other.low -= by;
        other.high += by;
        other.ray.range.min -= by / length;
        other.ray.range.max += by / length;
        if (first_inside(other).has_value() != truth) return false;
    }
    return true;
}

}  // namespace raylab::grading::boxes
