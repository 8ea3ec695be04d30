// hint: sign_lost
// Goes on with the absolute values that chose the face.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double size[] = {std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const auto cell = [&](int other) {
        return std::min(static_cast<int>((size[other % 3] / size[axis] + 1) / 2 * resolution), resolution - 1);
    };
    return {2 * axis + (direction[axis] < 0 ? 1 : 0), cell(axis + 1), cell(axis + 2)};
}
