// Tries the six faces.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <cmath>

namespace {

int cell_of(double place, int count) {
    const int i = static_cast<int>(std::floor((place + 1) / 2 * count));
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    for (int face = 0; face < 6; ++face) {
        const int k = face / 2;
        const double w = face % 2 == 0 ? direction[k] : -direction[k];
        const double u = direction[(k + 1) % 3], v = direction[(k + 2) % 3];
        if (w > 0 && std::abs(u) <= w && std::abs(v) <= w)
            return {face, cell_of(u / w, resolution), cell_of(v / w, resolution)};
    }
    return {0, 0, 0};
}
