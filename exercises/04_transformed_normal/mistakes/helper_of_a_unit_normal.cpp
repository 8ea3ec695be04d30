// hint: helper_axis
// Another axis is taken where the normal is nearly the first one: but only normals of length 1 and more are seen to be.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    const Vec3d away = std::abs(normal.x) < 0.8 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    const Vec3d along = glm::normalize(cross(normal, away)), across = glm::normalize(cross(normal, along));
    Vec3d u{0}, v{0};
    for (int i = 0; i < 3; ++i) {
        u += columns[static_cast<std::size_t>(i)] * along[i];
        v += columns[static_cast<std::size_t>(i)] * across[i];
    }
    const Vec3d upright = glm::normalize(cross(u, v));
    Vec3d carried{0};
    for (int i = 0; i < 3; ++i) carried += columns[static_cast<std::size_t>(i)] * normal[i];
    return dot(upright, carried) < 0 ? -upright : upright;
}
