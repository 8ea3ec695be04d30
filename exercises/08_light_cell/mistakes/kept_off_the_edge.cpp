// hint: cut_too_early
// Keeps the place below 1 by a thousandth, which is more than a cell where there are thousands.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
    const double largest = std::abs(direction[axis]);
    const int face = 2 * axis + (direction[axis] < 0);
    const auto number = [&](int next) {
        const double place = (direction[(axis + next) % 3] / largest + 1) / 2;
        return static_cast<int>(std::clamp(place, 0.0, 0.999) * resolution);
    };
    return {face, number(1), number(2)};
}
