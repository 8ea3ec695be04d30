// hint: wrong_side
// Takes the face on the other side.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d size{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double w = size[axis];
    const auto cell = [&](int along) {
        const double place = (direction[along % 3] / w + 1) / 2;
        return std::min(static_cast<int>(place * resolution), resolution - 1);
    };
    return {2 * axis + (direction[axis] < 0 ? 0 : 1), cell(axis + 1), cell(axis + 2)};
}
