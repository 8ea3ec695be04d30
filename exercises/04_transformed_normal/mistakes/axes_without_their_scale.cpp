// hint: scales_lost
// The transposed inverse of a matrix whose three axes were made unit.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    glm::dmat3 axes;
    for (int i = 0; i < 3; ++i) {
        const Vec3d& column = columns[static_cast<std::size_t>(i)];
        axes[i] = column / glm::length(column);
    }
    return glm::normalize(glm::transpose(glm::inverse(axes)) * normal);
}
