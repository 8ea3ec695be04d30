// In space: the ray of the place against the triangle's plane, from the place itself.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include "raylab/geometry/vector.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    Vec3d p[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [cx, cy, depth] = corners[i];
        p[i] = depth * Vec3d{cx - x, cy - y, 1};
    }
    int left = 0, right = 0;
    for (int i = 0; i < 3; ++i) {
        const double side = cross(p[i], p[(i + 1) % 3]).z;
        left += side > 0;
        right += side < 0;
    }
    if ((left > 0) == (right > 0)) return std::nullopt;
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
    if (normal.z == 0) return std::nullopt;
    return dot(normal, p[0]) / normal.z;
}
