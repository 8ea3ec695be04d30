#pragma once

#include "raylab/accelerator/grid/next_cell.h"

#include <span>
#include <vector>

namespace raylab::grading::grid_step {

// Origin, direction, the range's end, low corner, side, number of cells, the cell.
inline constexpr std::size_t inputs = 17;
inline constexpr std::size_t outputs = 4;  // 1 and the next cell, or 0 0 0 0

struct Arguments {
    RayOf<double> ray;
    UniformGrid grid;
    Cell cell;
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    const auto cell = [&](std::size_t i) {
        return Cell{static_cast<int>(in[i]), static_cast<int>(in[i + 1]), static_cast<int>(in[i + 2])};
    };
    return {{vector(0), vector(3), {0, in[6]}}, {vector(7), in[10], cell(11)}, cell(14)};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [ray, grid, cell] = given;
    std::vector<double> in;
    const auto put = [&](const Vec3d& v) { in.insert(in.end(), {v.x, v.y, v.z}); };
    const auto put_cell = [&](const Cell& c) { in.insert(in.end(), c.begin(), c.end()); };
    put(ray.origin);
    put(ray.direction);
    in.push_back(ray.range.max);
    put(grid.low);
    in.push_back(grid.side);
    put_cell(grid.cells);
    put_cell(cell);
    return in;
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&next_cell) function, std::span<const double> in, std::span<double> out) {
    const auto [ray, grid, cell] = arguments(in);
    const auto next = function(ray, grid, cell);
    out[0] = next ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis + 1] = next ? (*next)[axis] : 0;
}

}  // namespace raylab::grading::grid_step
