// hint: wrong_side
// Tries three axes, each as if it had one face.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    for (int axis = 0; axis < 3; ++axis) {
        const double w = std::abs(direction[axis]);
        const double u = direction[(axis + 1) % 3], v = direction[(axis + 2) % 3];
        if (std::abs(u) > w || std::abs(v) > w) continue;
        const auto cell = [&](double across) {
            const double number = std::floor((across / w + 1) / 2 * resolution);
            return static_cast<int>(std::clamp(number, 0.0, resolution - 1.0));
        };
        return {2 * axis, cell(u), cell(v)};
    }
    return {0, 0, 0};
}
