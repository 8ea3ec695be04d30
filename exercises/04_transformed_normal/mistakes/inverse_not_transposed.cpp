// hint: inverse_not_transposed
// Multiplies by the inverse, and forgets to transpose it.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const double determinant = dot(x, cross(y, z));
    const Vec3d a = cross(y, z) / determinant;
    const Vec3d b = cross(z, x) / determinant;
    const Vec3d c = cross(x, y) / determinant;  // rows of the inverse
    return glm::normalize(Vec3d{dot(a, normal), dot(b, normal), dot(c, normal)});
}
