// hint: range
// Goes on to the point of the face, and multiplies its coordinates by the resolution. Half of them are below 0.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <glm/common.hpp>

#include <algorithm>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d size = glm::abs(direction);
    int face = 0;
    if (size.y > size.x) face = 2;
    if (size.z > size[face / 2]) face = 4;
    const Vec3d point = direction / size[face / 2];
    const Vec3d numbers = glm::min(glm::floor(point * static_cast<double>(resolution)), Vec3d(resolution - 1));

    const auto column = static_cast<int>(numbers[(face / 2 + 1) % 3]);
    const auto row = static_cast<int>(numbers[(face / 2 + 2) % 3]);
    return {point[face / 2] < 0 ? face + 1 : face, column, row};
}
