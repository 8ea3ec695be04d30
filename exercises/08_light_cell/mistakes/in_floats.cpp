// hint: few_digits
// or: one_group
// Has the place in floats, which are too coarse for thousands of cells.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const auto cell = [&](int other) {
        const auto place = static_cast<float>(direction[other % 3] / std::abs(direction[axis]));
        return std::min(static_cast<int>((place + 1) / 2 * static_cast<float>(resolution)), resolution - 1);
    };
    return {2 * axis + (direction[axis] < 0 ? 1 : 0), cell(axis + 1), cell(axis + 2)};
}
