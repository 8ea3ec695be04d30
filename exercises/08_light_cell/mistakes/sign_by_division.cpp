// hint: zero_over_zero
// Has the signs from x / |x|.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d size{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double w = size[axis];
    const Vec3d signs = direction / size;
    const auto cell = [&](int along) {
        const double place = (signs[along % 3] * size[along % 3] / w + 1) / 2;
        return std::min(static_cast<int>(place * resolution), resolution - 1);
    };
    return {2 * axis + (signs[axis] < 0 ? 1 : 0), cell(axis + 1), cell(axis + 2)};
}
