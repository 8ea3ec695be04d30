// hint: largest_of_three
// x if it is larger than y, otherwise y if it is larger than z, otherwise z.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    const int axis = x > y ? 0 : y > z ? 1 : 2;
    const double size = std::abs(direction[axis]);
    const auto cell = [&](int other) {
        const double place = direction[(axis + other) % 3] / size;
        const double part = (place + 1) / 2;
        return std::clamp(static_cast<int>(std::floor(part * resolution)), 0, resolution - 1);
    };
    return {2 * axis + (direction[axis] < 0 ? 1 : 0), cell(1), cell(2)};
}
