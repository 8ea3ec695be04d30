// hint: small_is_not_singular
// A small determinant counts as a negative one.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d carried = normal.x * cross(y, z) + normal.y * cross(z, x) + normal.z * cross(x, y);
    const double determinant = dot(x, cross(y, z));
    return glm::normalize(determinant > 1e-10 ? carried : -carried);
}
