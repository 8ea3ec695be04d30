#include "raylab/sampling/mapping/ggx.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <algorithm>

namespace raylab {

// Stretched by 1 / alpha along z, the facets become a half sphere that is seen from some direction: a disk in front and
// half an ellipse below it. Points of that silhouette are uniform in the area that shows.
Vec3d ggx_visible_normal(const Vec3d& seen_from, double alpha, double u, double v) {
    const Vec3d stretched = glm::normalize(Vec3d{alpha * seen_from.x, alpha * seen_from.y, seen_from.z});
    const double across = std::hypot(stretched.x, stretched.y);
    const Vec3d side = across > 0 ? Vec3d{-stretched.y, stretched.x, 0} / across : Vec3d{1, 0, 0};
    const Vec3d up = cross(stretched, side);
    const auto [x, on_disk] = concentric_disk(u, v);
    const double share = 0.5 * (1 + stretched.z);  // of the disk's height that is left below the middle
    const double y = (1 - share) * std::sqrt(std::max(0.0, 1 - x * x)) + share * on_disk;
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    const Vec3d on_sphere = x * side + y * up + z * stretched;
    return glm::normalize(Vec3d{alpha * on_sphere.x, alpha * on_sphere.y, std::max(0.0, on_sphere.z)});
}

}  // namespace raylab
