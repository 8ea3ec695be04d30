// hint: not_divided
// Tries six faces. The distance along the axis tells which one it is, and is then forgotten.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    const auto number = [&](double place) {
        return static_cast<int>(std::clamp(std::floor((place + 1) * resolution / 2), 0.0, resolution - 1.0));
    };
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double distance = face % 2 == 0 ? direction[axis] : -direction[axis];
        const double u = direction[(axis + 1) % 3], v = direction[(axis + 2) % 3];
        if (distance > 0 && std::max(std::abs(u), std::abs(v)) <= distance) return {face, number(u), number(v)};
    }
    return {0, 0, 0};
}
