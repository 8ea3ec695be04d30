// hint: small_is_not_singular
// Takes a small determinant for none.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const double determinant = dot(x, cross(y, z));
    if (std::abs(determinant) < 1e-8) return glm::normalize(normal);
    const Vec3d carried = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    return glm::normalize(carried / determinant);
}
