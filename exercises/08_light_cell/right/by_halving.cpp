// Finds the column and the row by halving, without a division.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

namespace {

// The last of the borders (2 i / resolution - 1) w that is not beyond u.
int last_border(double u, double w, int resolution) {
    int low = 0, high = resolution;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (u >= (2.0 * middle / resolution - 1) * w ? low : high) = middle;
    }
    return low;
}

}  // namespace

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    int axis = 0;
    for (int i : {1, 2})
        if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
    const double w = std::abs(direction[axis]);
    return {2 * axis + (std::signbit(direction[axis]) ? 1 : 0), last_border(direction[(axis + 1) % 3], w, resolution),
            last_border(direction[(axis + 2) % 3], w, resolution)};
}
