#pragma once

#include "raylab/accelerator/octree/point_in_next_cell.h"

#include <span>
#include <vector>

namespace raylab::grading::next_cell {

inline constexpr std::size_t inputs = 11;  // the cube's corner and side, the smallest side, origin, direction
inline constexpr std::size_t outputs = 3;  // a point

struct Arguments {
    OctreeCube cube;
    double smallest;
    Vec3d origin, direction;
};

inline Arguments arguments(std::span<const double> in) {
    return {{{in[0], in[1], in[2]}, in[3]}, in[4], {in[5], in[6], in[7]}, {in[8], in[9], in[10]}};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [cube, smallest, o, d] = given;
    return {cube.low.x, cube.low.y, cube.low.z, cube.side, smallest, o.x, o.y, o.z, d.x, d.y, d.z};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&point_in_next_cell) function, std::span<const double> in, std::span<double> out) {
    const auto [cube, smallest, origin, direction] = arguments(in);
    const Vec3d point = function(cube, smallest, origin, direction);
    for (int axis = 0; axis < 3; ++axis) out[static_cast<std::size_t>(axis)] = point[axis];
}

}  // namespace raylab::grading::next_cell
