// hint: wrong_side
// Each axis has one face.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const auto cell = [&](int other) {
        const double place = direction[other % 3] / std::abs(direction[axis]);
        return std::min(static_cast<int>((place + 1) / 2 * resolution), resolution - 1);
    };
    return {2 * axis, cell(axis + 1), cell(axis + 2)};
}
