// hint: sign_aside
// Compares coordinates with their signs: no negative face is ever found, unless all are negative.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const int axis = direction.x >= direction.y && direction.x >= direction.z ? 0 : direction.y >= direction.z ? 1 : 2;
    const double w = std::abs(direction[axis]);
    const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
    const auto cell = [&](int along) {
        const double place = (direction[along % 3] / w + 1) / 2;
        return std::clamp(static_cast<int>(place * resolution), 0, resolution - 1);
    };
    return {face, cell(axis + 1), cell(axis + 2)};
}
