#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

namespace {

// The cell in which coordinate / size lies, which runs from -1 to 1.
int cell_along(double coordinate, double size, int resolution) {
    const auto cell = static_cast<int>((coordinate / size + 1) / 2 * resolution);
    return std::min(cell, resolution - 1);  // the cube's edge belongs to the last one
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const double depth = direction[axis], size = std::abs(depth);
    return {2 * axis + (depth < 0 ? 1 : 0), cell_along(direction[(axis + 1) % 3], size, resolution),
            cell_along(direction[(axis + 2) % 3], size, resolution)};
}
