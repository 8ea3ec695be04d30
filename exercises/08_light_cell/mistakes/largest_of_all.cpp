// hint: sign_aside
// The largest coordinate, with its sign.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <cmath>

namespace {

int cell_of(double place, int count) {
    const int i = static_cast<int>(std::floor((place + 1) / 2 * count));
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    int k = 0;
    for (int i = 1; i < 3; ++i)
        if (direction[i] > direction[k]) k = i;
    const double size = std::abs(direction[k]);
    return {2 * k + (direction[k] < 0 ? 1 : 0), cell_of(direction[(k + 1) % 3] / size, resolution),
            cell_of(direction[(k + 2) % 3] / size, resolution)};
}
