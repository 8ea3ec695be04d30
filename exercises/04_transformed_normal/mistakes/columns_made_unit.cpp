// hint: scales_lost
// Makes the columns unit first, so that small maps are no problem.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const Vec3d a = glm::normalize(columns[0]), b = glm::normalize(columns[1]), c = glm::normalize(columns[2]);
    const Vec3d sum = normal.x * cross(b, c) + normal.y * cross(c, a) + normal.z * cross(a, b);
    return glm::normalize(dot(a, cross(b, c)) < 0 ? -sum : sum);
}
