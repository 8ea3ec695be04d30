// hint: helper_axis
// A tangent by the x axis, always.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto map = [&](Vec3d v) { return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z; };
    Vec3d t = cross(Vec3d{1, 0, 0}, normal), s = cross(normal, t);
    Vec3d out = glm::normalize(cross(map(t), map(s)));
    if (dot(out, map(normal)) < 0) out = -out;
    return out;
}
