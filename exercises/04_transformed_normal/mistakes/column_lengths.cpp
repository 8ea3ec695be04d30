// hint: scales_only
// Divides by the lengths of the columns.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    return glm::normalize(Vec3d{normal.x / glm::length(columns[0]), normal.y / glm::length(columns[1]),
                                normal.z / glm::length(columns[2])});
}
