// Where the ray meets the plane of the face, from its corner.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const Vec3d a{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    int k = 0;
    if (a.y > a[k]) k = 1;
    if (a.z > a[k]) k = 2;

    const Vec3d at = direction / a[k];
    const auto count = [&](double x) { return std::min(resolution - 1, static_cast<int>((x + 1) * resolution / 2)); };
    return {direction[k] > 0 ? 2 * k : 2 * k + 1, count(at[(k + 1) % 3]), count(at[(k + 2) % 3])};
}
