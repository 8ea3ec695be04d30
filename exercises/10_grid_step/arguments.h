#pragma once

#include "raylab/accelerator/next_cell.h"

#include <span>

namespace raylab::grading::grid_step {

inline constexpr std::size_t inputs = 17;  // origin, direction, the range's end, low corner, side, how many cells, the cell
inline constexpr std::size_t outputs = 4;  // 1 and the next cell, or 0 0 0 0

struct Arguments {
    RayOf<double> ray;
    UniformGrid grid;
    Cell cell;
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    const auto cell = [&](std::size_t i) { return Cell{static_cast<int>(in[i]), static_cast<int>(in[i + 1]), static_cast<int>(in[i + 2])}; };
    return {{vector(0), vector(3), {0, in[6]}}, {vector(7), in[10], cell(11)}, cell(14)};
}

/// One case through one function of the slot's type.
inline void answer(decltype(&next_cell) function, std::span<const double> in, std::span<double> out) {
    const auto [ray, grid, cell] = arguments(in);
    const auto next = function(ray, grid, cell);
    out[0] = next ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis + 1] = next ? (*next)[axis] : 0;
}

}  // namespace raylab::grading::grid_step
