// hint: checkerboard
// Writes the minors down, and not the signs of the cofactors.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [a, b, c] = columns;
    const Vec3d of_x{b.y * c.z - b.z * c.y, b.x * c.z - b.z * c.x, b.x * c.y - b.y * c.x};
    const Vec3d of_y{a.y * c.z - a.z * c.y, a.x * c.z - a.z * c.x, a.x * c.y - a.y * c.x};
    const Vec3d of_z{a.y * b.z - a.z * b.y, a.x * b.z - a.z * b.x, a.x * b.y - a.y * b.x};
    const Vec3d sum = normal.x * of_x + normal.y * of_y + normal.z * of_z;
    return glm::normalize(dot(a, cross(b, c)) < 0 ? -sum : sum);
}
