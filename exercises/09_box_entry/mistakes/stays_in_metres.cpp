// hint: distance
// Makes the direction one long and the range metres with it, and gives the metres of the entry.
#include "raylab/geometry/box_entry.h"

#include <utility>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    const double length = glm::length(ray.direction);
    const Vec3d way = ray.direction / length;
    double near = ray.range.min * length, far = ray.range.max * length;
    for (int axis = 0; axis < 3; ++axis) {
        double first = low[axis] - ray.origin[axis], last = high[axis] - ray.origin[axis];
        if (way[axis] == 0) {
            if (first > 0 || last < 0) return std::nullopt;
            continue;
        }
        if (way[axis] < 0) std::swap(first, last);
        if (first / way[axis] > near) near = first / way[axis];
        if (last / way[axis] < far) far = last / way[axis];
    }
    return near <= far ? std::optional(near) : std::nullopt;
}
