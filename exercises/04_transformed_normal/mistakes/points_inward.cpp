// hint: points_inward
// Points to the other side of the surface.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d carried = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    return glm::normalize(dot(x, cross(y, z)) < 0 ? carried : -carried);
}
