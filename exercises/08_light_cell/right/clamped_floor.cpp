// floor, and a clamp on both sides.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <cmath>

namespace {

int cell_of(double place, int count) {
    const int i = static_cast<int>(std::floor((place + 1) / 2 * count));
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d a{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    int k = 0;
    if (a.y > a[k]) k = 1;
    if (a.z > a[k]) k = 2;

    const double u = direction[(k + 1) % 3] / a[k], v = direction[(k + 2) % 3] / a[k];
    return {2 * k + (direction[k] < 0 ? 1 : 0), cell_of(u, resolution), cell_of(v, resolution)};
}
