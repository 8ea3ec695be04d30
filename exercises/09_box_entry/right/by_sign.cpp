// Near and far planes told apart by the sign of the direction; comparisons that NaN fails.
#include "raylab/geometry/box_entry.h"

#include <cmath>

std::optional<double> raylab::box_entry(const RayOf<double>& ray, const Vec3d& low, const Vec3d& high) {
    double near = ray.range.min, far = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / ray.direction[axis];
        const bool backward = std::signbit(ray.direction[axis]);
        const double in = ((backward ? high : low)[axis] - ray.origin[axis]) * inverse;
        const double out = ((backward ? low : high)[axis] - ray.origin[axis]) * inverse;
        near = in > near ? in : near;
        far = out < far ? out : far;
    }
    return near <= far ? std::optional(near) : std::nullopt;
}
