// Cofactors, turned by the sign of the determinant.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const Vec3d yz = cross(columns[1], columns[2]), zx = cross(columns[2], columns[0]),
                xy = cross(columns[0], columns[1]);
    const double side = std::copysign(1.0, dot(columns[0], yz));
    return glm::normalize(side * (normal.x * yz + normal.y * zx + normal.z * xy));
}
