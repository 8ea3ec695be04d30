// hint: transposed_not_inverted
// Multiplies by the transpose, and forgets to invert it.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    return glm::normalize(Vec3d{dot(x, normal), dot(y, normal), dot(z, normal)});
}
