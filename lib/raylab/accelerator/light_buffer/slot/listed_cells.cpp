#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using raylab::Vec3d;

// What is left of a convex polygon where inside(corner) >= 0.
template <class Inside>
std::vector<Vec3d> cut(const std::vector<Vec3d>& polygon, const Inside& inside) {
    std::vector<Vec3d> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d& here = polygon[i];
        const Vec3d& next = polygon[(i + 1) % polygon.size()];
        const double a = inside(here), b = inside(next);
        if (a >= 0) left.push_back(here);
        if ((a < 0) != (b < 0)) left.push_back(here + a / (a - b) * (next - here));
    }
    return left;
}

}  // namespace

std::optional<raylab::CellRectangle> raylab::listed_cells(std::span<const Vec3d> corners, int face, int resolution) {
    std::vector<Vec3d> seen;
    for (const Vec3d& p : corners)  // as u, v, w
        seen.emplace_back(p[(face / 2 + 1) % 3], p[(face / 2 + 2) % 3], face % 2 == 0 ? p[face / 2] : -p[face / 2]);
    // Where |u| <= w, w is not negative: nothing behind the light is left, and so nothing is divided by a negative w.
    seen = cut(seen, [](const Vec3d& p) { return p.z - p.x; });
    seen = cut(seen, [](const Vec3d& p) { return p.z + p.x; });
    seen = cut(seen, [](const Vec3d& p) { return p.z - p.y; });
    seen = cut(seen, [](const Vec3d& p) { return p.z + p.y; });
    if (seen.empty()) return std::nullopt;
    // The light itself is on the polygon, which is seen through every cell.
    if (std::ranges::any_of(seen, [](const Vec3d& p) { return p.z == 0; }))
        return CellRectangle{0, resolution - 1, 0, resolution - 1};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low[] = {infinity, infinity}, high[] = {-infinity, -infinity};
    for (const Vec3d& p : seen)
        for (int axis = 0; axis < 2; ++axis) {
            const double place = (p[axis] / p.z + 1) / 2 * resolution;
            low[axis] = std::min(low[axis], place);
            high[axis] = std::max(high[axis], place);
        }
    const auto first = [&](double place) {
        return std::clamp(static_cast<int>(std::ceil(place)) - 1, 0, resolution - 1);
    };
    const auto last = [&](double place) { return std::clamp(static_cast<int>(std::floor(place)), 0, resolution - 1); };
    return CellRectangle{first(low[0]), last(high[0]), first(low[1]), last(high[1])};
}
