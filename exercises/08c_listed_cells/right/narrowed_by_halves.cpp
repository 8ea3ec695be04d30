// Halves columns and rows from outside, as long as the outer half shows nothing.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <vector>

namespace {

// Whether a convex polygon of (u, v, w) is seen between these borders of columns and rows, in cells.
bool is_seen(std::vector<raylab::Vec3d> polygon, double left, double right, double low, double high, double cells) {
    for (const raylab::Vec3d& inward : {raylab::Vec3d{cells, 0, cells - 2 * left},
                                        {-cells, 0, 2 * right - cells},
                                        {0, cells, cells - 2 * low},
                                        {0, -cells, 2 * high - cells}}) {
        std::vector<raylab::Vec3d> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double from = dot(inward, a), to = dot(inward, b);
            if (from >= 0) kept.push_back(a);
            if ((from > 0 && to < 0) || (from < 0 && to > 0)) kept.push_back(a + (b - a) * (from / (from - to)));
        }
        polygon = kept;
    }
    return !polygon.empty();
}

}  // namespace

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2, n = resolution;
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners)
        seen.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? p[axis] : -p[axis]});
    if (!is_seen(seen, 0, n, 0, n, n)) return std::nullopt;
    // The first number for which `holds`, which is true from some number on.
    const auto first = [&](const auto& holds) {
        int low = 0, high = n - 1;
        while (low < high) {
            const int middle = (low + high) / 2;
            if (holds(middle))
                high = middle;
            else
                low = middle + 1;
        }
        return low;
    };
    CellRectangle cells{};
    cells.first_column = first([&](int i) { return is_seen(seen, 0, i + 1, 0, n, n); });
    cells.last_column = n - 1 - first([&](int i) { return is_seen(seen, n - 1 - i, n, 0, n, n); });
    cells.first_row = first([&](int i) { return is_seen(seen, 0, n, 0, i + 1, n); });
    cells.last_row = n - 1 - first([&](int i) { return is_seen(seen, 0, n, n - 1 - i, n, n); });
    return cells;
}
