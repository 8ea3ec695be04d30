// hint: helper_axis
// Two tangents by an axis that may be the normal's own.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d first = cross(normal, Vec3d{0, 1, 0});
    const Vec3d second = cross(normal, first);
    const auto carried = [&](const Vec3d& v) { return x * v.x + y * v.y + z * v.z; };
    const Vec3d upright = glm::normalize(cross(carried(first), carried(second)));
    return dot(upright, carried(normal)) > 0 ? upright : -upright;
}
