#pragma once

#include "arguments.h"

#include <limits>

namespace raylab::grading::grid_step {

// A cell from inside: each wall has the colour of the answer; one wall is the end of the grid, and dark.
inline constexpr int picture_width = 240;
inline constexpr int picture_height = 160;

inline constexpr double endless = std::numeric_limits<double>::infinity();

inline Arguments looking(int x, int y) {
    const double scale = 1.9 / picture_height;
    const Vec3d eye{3.3, 2.45, 0.8};
    const Vec3d direction{(x + 0.5 - 0.5 * picture_width) * scale - 0.15, (0.5 * picture_height - y - 0.5) * scale, -1};
    return {{eye, direction, {0, endless}}, {{0, 0, -2}, 1, {4, 5, 5}}, {3, 2, 2}};
}

}  // namespace raylab::grading::grid_step
