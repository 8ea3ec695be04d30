// hint: small_is_not_singular
// Refuses a small determinant.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 m(columns[0], columns[1], columns[2]);

    if (std::abs(glm::determinant(m)) < 1e-9) return {0, 0, 1};
    return glm::normalize(glm::transpose(glm::inverse(m)) * normal);
}
