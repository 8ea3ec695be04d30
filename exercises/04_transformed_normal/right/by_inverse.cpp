// Cramer's rule for the inverse, then its transpose.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const double determinant = dot(x, cross(y, z));
    const Vec3d row[3] = {cross(y, z) / determinant, cross(z, x) / determinant, cross(x, y) / determinant};
    Vec3d carried{0, 0, 0};
    for (int i = 0; i < 3; ++i) carried += row[i] * normal[i];
    return carried / std::sqrt(dot(carried, carried));
}
