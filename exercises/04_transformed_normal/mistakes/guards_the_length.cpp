// hint: small_is_not_singular
// or: one_group
// A short vector is taken for none.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d carried = normal.x * cross(y, z) + normal.y * cross(z, x) + normal.z * cross(x, y);
    const double length = glm::length(carried);
    if (length < 1e-9) return normal;
    return (dot(x, cross(y, z)) < 0 ? -carried : carried) / length;
}
