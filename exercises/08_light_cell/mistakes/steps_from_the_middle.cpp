// hint: towards_zero
// Counts cells from the middle of the face, in whole steps, and then from its edge.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <glm/common.hpp>

#include <algorithm>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d size = glm::abs(direction);
    const double largest = std::max({size.x, size.y, size.z});
    const int axis = size.x == largest ? 0 : size.y == largest ? 1 : 2;

    const Vec3d steps = glm::trunc(direction / largest * (resolution / 2.0));
    const int middle = resolution / 2;
    const auto number = [&](int along) {
        return std::min(middle + static_cast<int>(steps[(axis + along) % 3]), resolution - 1);
    };
    return {direction[axis] < 0 ? 2 * axis + 1 : 2 * axis, number(1), number(2)};
}
