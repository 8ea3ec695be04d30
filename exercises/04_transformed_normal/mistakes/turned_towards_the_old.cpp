// hint: compared_with_the_old
// or: points_inward
// Turns the normal to the side of the old one.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 m(columns[0], columns[1], columns[2]);

    const Vec3d carried = glm::normalize(glm::transpose(glm::inverse(m)) * normal);
    return dot(carried, normal) < 0 ? -carried : carried;
}
