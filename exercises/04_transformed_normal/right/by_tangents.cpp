// Carries two tangents and stands upright on both.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const Vec3d aside = std::abs(normal.x) < 0.7 * glm::length(normal) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d first = cross(normal, aside);
    const Vec3d second = cross(normal, first);
    const auto carried = [&](const Vec3d& v) { return x * v.x + y * v.y + z * v.z; };
    const Vec3d upright = glm::normalize(cross(carried(first), carried(second)));
    return dot(upright, carried(normal)) > 0 ? upright : -upright;
}
