// hint: other_layout
// The table of cube maps: columns and rows as they are seen from inside, downward.
#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <cmath>

raylab::LightCell raylab::light_cell(const Vec3d& direction, int resolution) {
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
    const double largest = std::abs(direction[axis]);
    const int face = 2 * axis + (direction[axis] < 0);
    const double sign = direction[axis] < 0 ? -1 : 1;
    const Vec3d p = direction / largest;
    const double across = axis == 0 ? -sign * p.z : axis == 1 ? p.x : sign * p.x;
    const double down = axis == 1 ? sign * p.z : -p.y;
    const auto number = [&](double place) {
        return std::min(static_cast<int>((place + 1) / 2 * resolution), resolution - 1);
    };
    return {face, number(across), number(down)};
}
