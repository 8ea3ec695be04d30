// hint: start_for_range
// or: range, from_zero_on
// Asks first whether the origin is in the box, and is done if so, wherever the range begins.
#include "raylab/geometry/box_entry.h"

#include <cmath>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    if (glm::clamp(ray.origin, low, high) == ray.origin) return ray.range.min;

    double near = ray.range.min, far = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const bool backward = std::signbit(ray.direction[axis]);
        const double in = ((backward ? high : low)[axis] - ray.origin[axis]) / ray.direction[axis];
        const double out = ((backward ? low : high)[axis] - ray.origin[axis]) / ray.direction[axis];
        near = in > near ? in : near;
        far = out < far ? out : far;
    }
    return near <= far ? std::optional(near) : std::nullopt;
}
