// hint: three_to_five
// or: partly_seen
// Takes polygons apart into triangles: one, and a second one where there is a fourth corner.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const auto depth = [&](const Vec3d& p) { return face % 2 == 0 ? p[axis] : -p[axis]; };
    int first[] = {resolution, resolution}, last[] = {-1, -1};
    const auto take_triangle = [&](std::vector<Vec3d> part) {
        for (const int along : {(axis + 1) % 3, (axis + 2) % 3})
            for (const double side : {-1.0, 1.0}) {
                const auto room = [&](const Vec3d& p) { return depth(p) - side * p[along]; };
                std::vector<Vec3d> kept;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const Vec3d &p = part[i], &q = part[(i + 1) % part.size()];
                    if (room(p) >= 0) kept.push_back(p);
                    if (room(p) * room(q) < 0) kept.push_back(p + room(p) / (room(p) - room(q)) * (q - p));
                }
                part.swap(kept);
            }
        for (const Vec3d& p : part)
            for (const int k : {0, 1}) {
                const double place = (p[(axis + 1 + k) % 3] / depth(p) + 1) / 2 * resolution;
                first[k] = std::min(first[k], std::clamp(static_cast<int>(std::ceil(place)) - 1, 0, resolution - 1));
                last[k] = std::max(last[k], std::clamp(static_cast<int>(std::floor(place)), 0, resolution - 1));
            }
    };
    take_triangle({corners[0], corners[1], corners[2]});
    if (corners.size() > 3) take_triangle({corners[0], corners[2], corners[3]});
    if (last[0] < 0) return std::nullopt;
    return CellRectangle{first[0], last[0], first[1], last[1]};
}
