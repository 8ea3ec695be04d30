// hint: like_a_point
// Carries the normal by the map itself, as a point of the surface.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    return glm::normalize(x * normal.x + y * normal.y + z * normal.z);
}
