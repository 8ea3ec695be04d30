// hint: mirrored
// Asks of each strip of the face whether the polygon reaches into it, and begins at the side of the larger coordinate.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const auto reaches = [&](int along, int across, double low, double high) {
        std::vector<Vec3d> part(corners.begin(), corners.end());
        for (int side = 0; side < 4; ++side) {
            const auto room = [&](const Vec3d& p) {
                const double w = face % 2 == 0 ? p[axis] : -p[axis];
                const std::array rooms{p[along] - low * w, high * w - p[along], w - p[across], w + p[across]};
                return rooms[static_cast<std::size_t>(side)];
            };
            std::vector<Vec3d> next;
            for (std::size_t i = 0; i < part.size(); ++i) {
                const Vec3d &a = part[i], &b = part[(i + 1) % part.size()];
                if (room(a) >= 0) next.push_back(a);
                if (room(a) * room(b) < 0) next.push_back(a + room(a) / (room(a) - room(b)) * (b - a));
            }
            part.swap(next);
        }
        return !part.empty();
    };
    const auto strips = [&](int along, int across) {
        std::pair<int, int> ends{resolution, -1};
        for (int strip = 0; strip < resolution; ++strip)
            if (reaches(along, across, 1 - 2.0 * (strip + 1) / resolution, 1 - 2.0 * strip / resolution))
                ends = {std::min(ends.first, strip), strip};
        return ends;
    };
    const auto columns = strips((axis + 1) % 3, (axis + 2) % 3), rows = strips((axis + 2) % 3, (axis + 1) % 3);
    if (columns.second < 0) return std::nullopt;
    return CellRectangle{columns.first, columns.second, rows.first, rows.second};
}
