// hint: helper_axis
// Carries unit tangents made with y as the helper, and the map's determinant says the side.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 map(columns[0], columns[1], columns[2]);
    const Vec3d n = glm::normalize(normal);
    const Vec3d upward{0, 1, 0};
    const Vec3d tangent = glm::normalize(cross(upward, n));
    const Vec3d bitangent = cross(n, tangent);
    const Vec3d carried = glm::normalize(cross(map * tangent, map * bitangent));
    return glm::determinant(map) < 0 ? -carried : carried;
}
