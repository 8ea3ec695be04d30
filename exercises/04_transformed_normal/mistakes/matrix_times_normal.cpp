// hint: like_a_point
// The matrix, as it stands.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 m(columns[0], columns[1], columns[2]);
    return glm::normalize(m * normal);
}
