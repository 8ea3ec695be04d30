// hint: negative_faces
// Brings negative faces to the front by the other sign of all three coordinates, which mirrors columns and rows.
#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    const auto turned = [&](const Vec3d& p) { return sign * Vec3d{p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]}; };
    const Vec3d sides[] = {{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}};
    std::vector<Vec3d> front;
    std::ranges::transform(corners, std::back_inserter(front), turned);
    for (const Vec3d& inward : sides) {
        std::vector<Vec3d> kept;
        for (std::size_t i = 0; i < front.size(); ++i) {
            const Vec3d &a = front[i], &b = front[i + 1 < front.size() ? i + 1 : 0];
            const double from = dot(inward, a), to = dot(inward, b);
            if (from >= 0) kept.push_back(a);
            if (from * to < 0) kept.push_back(a + from / (from - to) * (b - a));
        }
        front = kept;
    }
    if (front.empty()) return std::nullopt;
    for (Vec3d& p : front) p = (p / p.z + 1.0) / 2.0 * static_cast<double>(resolution);
    const auto [left, right] = std::ranges::minmax(front, {}, &Vec3d::x);
    const auto [low, high] = std::ranges::minmax(front, {}, &Vec3d::y);
    const auto cell = [&](double number) { return static_cast<int>(std::clamp(number, 0.0, resolution - 1.0)); };
    return CellRectangle{cell(std::ceil(left.x) - 1), cell(right.x), cell(std::ceil(low.y) - 1), cell(high.y)};
}
