// Cuts just before the light, divides, and cuts the picture at the face's edges.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    using Point = std::array<double, 3>;
    const int axis = face / 2;
    double size = 0;
    std::vector<Point> polygon;
    for (const Vec3d& p : corners) {
        polygon.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? p[axis] : -p[axis]});
        size = std::max(size, length(p));
    }
    const auto cut = [&](auto inside) {
        std::vector<Point> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double from = inside(a), to = inside(b);
            if (from >= 0) kept.push_back(a);
            if ((from >= 0) == (to >= 0)) continue;
            Point crossing;
            for (std::size_t k = 0; k < 3; ++k) crossing[k] = a[k] + from / (from - to) * (b[k] - a[k]);
            kept.push_back(crossing);
        }
        polygon = kept;
    };
    cut([&](const Point& p) { return p[2] - 1e-7 * size; });
    for (Point& p : polygon) p = {p[0] / p[2], p[1] / p[2], 1};
    cut([](const Point& p) { return 1 - p[0]; });
    cut([](const Point& p) { return 1 + p[0]; });
    cut([](const Point& p) { return 1 - p[1]; });
    cut([](const Point& p) { return 1 + p[1]; });
    if (polygon.empty()) return std::nullopt;
    std::array<int, 2> first{}, last{};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [low, high] = std::ranges::minmax(polygon, {}, [&](const Point& p) { return p[k]; });
        const double step = 2.0 / resolution;
        first[k] = std::max(0, static_cast<int>(std::ceil((low[k] + 1) / step)) - 1);
        last[k] = std::min(resolution - 1, static_cast<int>(std::floor((high[k] + 1) / step)));
    }
    return CellRectangle{first[0], last[0], first[1], last[1]};
}
