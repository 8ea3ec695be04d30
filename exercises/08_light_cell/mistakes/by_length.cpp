// hint: ball_not_cube
// Divides by the length, as for a point of a ball.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d unit = glm::normalize(direction), size{std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
    const auto cell = [&](int along) { return static_cast<int>((unit[along % 3] + 1) / 2 * resolution); };
    return {face, cell(axis + 1), cell(axis + 2)};
}
