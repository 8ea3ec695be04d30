// hint: borders_below
// Rounds up and takes one off: nothing is left for the near edge of a face.
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
        const double place = direction[(axis + next) % 3] / largest;
        return static_cast<int>(std::ceil((place + 1) / 2 * resolution)) - 1;
    };
    return {face, number(1), number(2)};
}
