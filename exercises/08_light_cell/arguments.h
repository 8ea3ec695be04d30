#pragma once

#include "raylab/accelerator/light_buffer/light_cell.h"

#include <span>

namespace raylab::grading::cells {

inline constexpr std::size_t inputs = 4;   // the direction, the resolution
inline constexpr std::size_t outputs = 3;  // face, column, row

struct Arguments {
    Vec3d direction;
    int resolution;
};

inline Arguments arguments(std::span<const double> in) { return {{in[0], in[1], in[2]}, static_cast<int>(in[3])}; }

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&light_cell) function, std::span<const double> in, std::span<double> out) {
    const auto [direction, resolution] = arguments(in);
    const LightCell cell = function(direction, resolution);
    out[0] = cell.face;
    out[1] = cell.column;
    out[2] = cell.row;
}

}  // namespace raylab::grading::cells
