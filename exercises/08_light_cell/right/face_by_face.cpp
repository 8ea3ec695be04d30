// Each face written out.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

int cell(double place, int resolution) {
    return std::min(static_cast<int>((place + 1) * 0.5 * resolution), resolution - 1);
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const auto [x, y, z] = std::array{direction.x, direction.y, direction.z};
    const auto on = [&](int face, double u, double v) {
        return LightCell{face, cell(u, resolution), cell(v, resolution)};
    };
    if (std::abs(x) >= std::max(std::abs(y), std::abs(z))) return on(x > 0 ? 0 : 1, y / std::abs(x), z / std::abs(x));
    if (std::abs(y) >= std::abs(z)) return on(y > 0 ? 2 : 3, z / std::abs(y), x / std::abs(y));
    return on(z > 0 ? 4 : 5, x / std::abs(z), y / std::abs(z));
}
