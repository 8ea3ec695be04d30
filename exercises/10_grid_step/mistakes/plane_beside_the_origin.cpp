// hint: nearest_plane
// Takes the face ahead whose plane is the nearest to the origin, as if all were reached at the same speed.
#include "raylab/accelerator/grid/next_cell.h"

#include <algorithm>
#include <limits>

std::optional<raylab::Cell> raylab::next_cell(const RayOf<double>& ray, const UniformGrid& grid, const Cell& cell) {
    const Vec3d low = grid.low + grid.side * Vec3d(cell[0], cell[1], cell[2]), high = low + Vec3d(grid.side);
    Vec3d distance(std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] > 0) distance[axis] = glm::abs(high[axis] - ray.origin[axis]);
        if (ray.direction[axis] < 0) distance[axis] = glm::abs(low[axis] - ray.origin[axis]);
    }
    const double nearest = std::min({distance.x, distance.y, distance.z});
    const int axis = distance.x == nearest ? 0 : distance.y == nearest ? 1 : 2;
    const bool up = ray.direction[axis] > 0;
    const double plane = up ? high[axis] : low[axis];
    if ((plane - ray.origin[axis]) / ray.direction[axis] > ray.range.max) return std::nullopt;
    const auto i = static_cast<std::size_t>(axis);
    Cell next = cell;
    next[i] = up ? cell[i] + 1 : cell[i] - 1;
    if (next[i] < 0 || next[i] >= grid.cells[i]) return std::nullopt;
    return next;
}
