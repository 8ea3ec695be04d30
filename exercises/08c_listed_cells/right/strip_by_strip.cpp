// Asks of each column, and of each row, whether the polygon reaches into its wedge of the face.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = face % 2 == 0 ? 1 : -1;
    // Whether something lies where low <= p[along] / w <= high, and on the face across.
    const auto reaches = [&](int along, int across, double low, double high) {
        std::vector<Vec3d> part(corners.begin(), corners.end());
        for (int side = 0; side < 4; ++side) {
            std::vector<Vec3d> next;
            const auto room = [&](const Vec3d& p) {
                const double w = sign * p[axis];
                return side == 0   ? p[along] - low * w
                       : side == 1 ? high * w - p[along]
                       : side == 2 ? w - p[across]
                                   : w + p[across];
            };
            for (std::size_t i = 0; i < part.size(); ++i) {
                const Vec3d a = part[(i + part.size() - 1) % part.size()], b = part[i];
                if (room(a) * room(b) < 0) next.push_back(b + room(b) / (room(b) - room(a)) * (a - b));
                if (room(b) >= 0) next.push_back(b);
            }
            part.swap(next);
        }
        return !part.empty();
    };
    int ends[2][2] = {{-1, -1}, {-1, -1}};
    for (int cell = 0; cell < resolution; ++cell) {
        const double low = 2.0 * cell / resolution - 1, high = 2.0 * (cell + 1) / resolution - 1;
        for (int way = 0; way < 2; ++way)
            if (reaches(way == 0 ? u : v, way == 0 ? v : u, low, high)) {
                if (ends[way][0] < 0) ends[way][0] = cell;
                ends[way][1] = cell;
            }
    }
    if (ends[0][0] < 0) return std::nullopt;
    return CellRectangle{ends[0][0], ends[0][1], ends[1][0], ends[1][1]};
}
