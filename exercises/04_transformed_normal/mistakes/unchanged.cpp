// hint: unchanged
// Leaves the normal as it is in object space.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    return glm::normalize(normal);
}
