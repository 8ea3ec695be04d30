// hint: not_normalised
// Carries it by the inverse transpose, and leaves its length as it comes.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d carried = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    return carried / dot(x, cross(y, z));
}
