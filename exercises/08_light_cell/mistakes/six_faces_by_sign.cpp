// hint: numbers_of_faces
// Tries six faces, the three positive ones before the three negative ones.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    for (int face = 0; face < 6; ++face) {
        const int axis = face % 3;
        const double w = face < 3 ? direction[axis] : -direction[axis];
        const double u = direction[(axis + 1) % 3], v = direction[(axis + 2) % 3];
        if (w <= 0 || std::abs(u) > w || std::abs(v) > w) continue;
        const auto cell = [&](double across) {
            return std::min(static_cast<int>((across + w) / (2 * w) * resolution), resolution - 1);
        };
        return {face, cell(u), cell(v)};
    }
    return {0, 0, 0};
}
