// hint: half_of_odd
// Counts from the middle of the face, in halves of the resolution.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
    const double largest = std::abs(direction[axis]);
    const int face = 2 * axis + (direction[axis] < 0);
    const int half = resolution / 2;
    const auto number = [&](int next) {
        const double place = direction[(axis + next) % 3] / largest;
        return std::clamp(half + static_cast<int>(std::floor(half * place)), 0, resolution - 1);
    };
    return {face, number(1), number(2)};
}
