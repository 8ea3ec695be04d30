// hint: rounded
// Rounds to the nearest.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d a{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    int k = 0;
    if (a.y > a[k]) k = 1;
    if (a.z > a[k]) k = 2;

    const auto cell = [&](double p) {
        const long i = std::lround((p / a[k] + 1) / 2 * resolution);
        return i >= resolution ? resolution - 1 : static_cast<int>(i);
    };
    return {2 * k + (direction[k] < 0 ? 1 : 0), cell(direction[(k + 1) % 3]), cell(direction[(k + 2) % 3])};
}
