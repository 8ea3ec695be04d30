// hint: three_to_five
// or: partly_seen
// Polygons are quadrilaterals at most.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

using raylab::Vec3d;

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners.first(std::min<std::size_t>(corners.size(), 4)))
        seen.emplace_back(p[(face / 2 + 1) % 3], p[(face / 2 + 2) % 3], face % 2 == 0 ? p[face / 2] : -p[face / 2]);
    for (const int axis : {0, 1})
        for (const double side : {-1.0, 1.0}) {
            std::vector<Vec3d> left;
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const Vec3d &here = seen[i], &next = seen[(i + 1) % seen.size()];
                const double a = here.z - side * here[axis], b = next.z - side * next[axis];
                if (a >= 0) left.push_back(here);
                if ((a < 0) != (b < 0)) left.push_back(here + a / (a - b) * (next - here));
            }
            seen = left;
        }
    if (seen.empty()) return std::nullopt;
    double low[] = {1e9, 1e9}, high[] = {-1e9, -1e9};
    for (const Vec3d& p : seen)
        for (const int axis : {0, 1}) {
            const double place = (p[axis] / p.z + 1) / 2 * resolution;
            low[axis] = std::min(low[axis], place);
            high[axis] = std::max(high[axis], place);
        }
    const auto cell = [&](double number) { return std::clamp(static_cast<int>(number), 0, resolution - 1); };
    return CellRectangle{cell(std::ceil(low[0]) - 1), cell(std::floor(high[0])), cell(std::ceil(low[1]) - 1),
                         cell(std::floor(high[1]))};
}
