// hint: helper_axis
// Exchanges y and z for a tangent, with one sign turned: of a normal along x that leaves nothing.
#include "raylab/geometry/transformed_normal.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const glm::dmat3 map(columns[0], columns[1], columns[2]);
    const double a = normal.x, b = normal.y, c = normal.z;
    const Vec3d level{0, -c, b};
    const Vec3d steep{b * b + c * c, -a * b, -a * c};  // at right angles to both
    const Vec3d upright = cross(map * level, map * steep);
    return glm::normalize(glm::determinant(map) > 0 ? upright : -upright);
}
