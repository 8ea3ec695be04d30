// hint: sign_lost
// Writes each face out, with the sizes of the coordinates, which are at hand after the comparison.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <glm/common.hpp>

#include <algorithm>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const double x = direction.x, y = direction.y, z = direction.z;
    const Vec3d size = glm::abs(direction);
    const auto on = [&](int face, double u, double v) {
        const auto cell = [&](double place) {
            return std::min(static_cast<int>((place + 1) * 0.5 * resolution), resolution - 1);
        };
        return LightCell{face, cell(u), cell(v)};
    };
    if (size.x >= std::max(size.y, size.z)) return on(x > 0 ? 0 : 1, size.y / size.x, size.z / size.x);
    if (size.y >= size.z) return on(y > 0 ? 2 : 3, size.z / size.y, size.x / size.y);
    return on(z > 0 ? 4 : 5, size.x / size.z, size.y / size.z);
}
