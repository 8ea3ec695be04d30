// hint: normalised_too_early
// or: not_normalised
// Makes the normal unit before the map, not after it.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d unit = glm::normalize(normal);
    const Vec3d carried = cross(y, z) * unit.x + cross(z, x) * unit.y + cross(x, y) * unit.z;
    return carried / dot(x, cross(y, z));
}
