// hint: compared_with_the_old
// or: points_inward
// Stands upright on two carried tangents, on the side on which the normal was before the map.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const Vec3d n = glm::normalize(normal);
    const Vec3d helper = std::abs(n.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
    const Vec3d u = cross(n, helper), v = cross(n, u);
    const auto carry = [&](const Vec3d& t) { return t.x * columns[0] + t.y * columns[1] + t.z * columns[2]; };
    Vec3d upright = glm::normalize(cross(carry(u), carry(v)));
    if (dot(upright, n) < 0) upright *= -1.0;
    return upright;
}
