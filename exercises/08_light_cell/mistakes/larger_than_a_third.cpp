// hint: largest_of_three
// The first coordinate whose square is a third of the length's or more.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double third = dot(direction, direction) / 3 * (1 - 1e-9);
    const auto is_large = [&](int i) { return direction[i] * direction[i] >= third; };
    const int axis = is_large(0) ? 0 : is_large(1) ? 1 : 2;
    const double size = std::abs(direction[axis]);
    const auto cell = [&](int other) {
        const double place = direction[(axis + other) % 3] / size;
        const double part = (place + 1) / 2;
        return std::clamp(static_cast<int>(std::floor(part * resolution)), 0, resolution - 1);
    };
    return {2 * axis + (direction[axis] < 0 ? 1 : 0), cell(1), cell(2)};
}
