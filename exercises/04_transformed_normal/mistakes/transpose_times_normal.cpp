// hint: transposed_not_inverted
// The transpose, without the inverse.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 m(columns[0], columns[1], columns[2]);
    return glm::normalize(normal * m);
}
