#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    // The inverse transpose is the matrix of cofactors over the determinant; only the sign of the latter matters to a
    // direction, and no division is needed.
    const Vec3d carried = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    const bool mirrored = dot(x, cross(y, z)) < 0;
    return glm::normalize(mirrored ? -carried : carried);
}
