#pragma once

#include "arguments.h"

#include <algorithm>
#include <array>
#include <cmath>

// The cell into which the ray goes, from the definition of a cell, in long double, and the distance from any other
// answer.

namespace raylab::grading::next_cell {

struct Truth {
    int axis = 0;                      // the axis across which the ray leaves
    std::array<double, 3> low = {};    // of the smallest cell that the ray enters
    double margin = 0;                 // distance to any other answer, in smallest cells
    std::array<bool, 3> between = {};  // the ray is exactly between this cell and the one below it
};

inline Truth truth(const Arguments& given) {
    using Number = long double;
    std::array<Number, 3> t{}, exit{};
    Truth result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const Number d = given.direction[axis];
        const Number plane = d > 0 ? Number(given.cube.low[axis]) + given.cube.side : Number(given.cube.low[axis]);
        t[i] = d == 0 ? HUGE_VALL : (plane - given.origin[axis]) / d;
        if (t[i] < t[static_cast<std::size_t>(result.axis)]) result.axis = axis;
    }
    const auto across = static_cast<std::size_t>(result.axis);
    Number margin = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const Number s = given.smallest;
        exit[i] = Number(given.origin[axis]) + t[across] * given.direction[axis];
        if (i == across) {
            const Number face = given.direction[axis] > 0 ? given.cube.low[axis] + given.cube.side
                                                          : given.cube.low[axis] - given.smallest;
            result.low[i] = static_cast<double>(face);
            continue;
        }
        const Number cells = exit[i] / s;
        result.low[i] = static_cast<double>(std::floor(cells) * s);
        result.between[i] = cells == std::floor(cells);
        margin = std::min({margin, cells - std::floor(cells), std::ceil(cells) - cells});
    }
    result.margin = static_cast<double>(margin);
    return result;
}

/// Whether a point is inside the smallest cell that the ray enters: beyond the face by at least a millionth of it.
inline bool is_right(const Arguments& given, const Truth& truth, std::span<const double> point) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double inside = (point[i] - truth.low[i]) / given.smallest, margin = axis == truth.axis ? 1e-6 : 0;
        if (!(inside >= (truth.between[i] ? -1 : margin) && inside < 1 - margin)) return false;
    }
    return true;
}

}  // namespace raylab::grading::next_cell
