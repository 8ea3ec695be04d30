// hint: ball_not_cube
// A unit vector's coordinates.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <cmath>

namespace {

int cell_of(double place, int count) {
    const int i = static_cast<int>(std::floor((place + 1) / 2 * count));
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d d = glm::normalize(direction);
    int k = std::abs(d.y) > std::abs(d.x) ? 1 : 0;
    if (std::abs(d.z) > std::abs(d[k])) k = 2;
    return {2 * k + (d[k] < 0 ? 1 : 0), cell_of(d[(k + 1) % 3], resolution), cell_of(d[(k + 2) % 3], resolution)};
}
