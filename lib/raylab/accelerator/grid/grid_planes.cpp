#include "raylab/accelerator/grid/grid_planes.h"

#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace raylab {

namespace {

// The share of a cell's side by which boxes are grown: with it a box reaches into one cell more in 2^15. The traversal
// errs by 2^-50 of the distance to the farthest plane (GridWalk), so that a ray may start 2^34 cells away.
constexpr double slack_share = 0x1p-16;

// 16 MB, and 256 bytes for each box.
std::size_t max_cells_or_entries(std::size_t boxes) { return (std::size_t{1} << 22) + 64 * boxes; }

Vec3d sides_of(const Box& box) { return convert<double>(box.max) - convert<double>(box.min); }

// The side of cubes of which `count` fill a box; for a box that is flatter than one cube, cubes that fill its face or
// its edge.
double cell_side(const Box& box, double count) {
    const Vec3d sides = sides_of(box);
    std::array<double, 3> s{sides.x, sides.y, sides.z};
    std::ranges::sort(s, std::greater<>{});
    if (const double cube = std::cbrt(s[0] * s[1] * s[2] / count); cube > 0 && s[2] >= cube) return cube;
    if (const double square = std::sqrt(s[0] * s[1] / count); square > 0 && s[1] >= square) return square;
    return s[0] / count;
}

GridPlanes cut(const Box& box, double cell_side) {
    GridPlanes planes;
    const double slack = slack_share * cell_side;
    if (!(slack > 0x1p-45 * largest_coordinate(box))) return planes;
    planes.slack = slack;
    const Vec3d sides = sides_of(box);
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min[axis];
        const int cells = std::max(1, static_cast<int>(sides[axis] / cell_side));
        auto& along = planes.along[static_cast<std::size_t>(axis)];
        along.push_back(low - slack);
        // Scenes made by rule have faces at even fractions of a side. Planes slightly beside those are reached by fewer
        // boxes.
        for (int k = 1; k < cells; ++k) along.push_back(low + sides[axis] * k / cells - 4 * slack);
        along.push_back(box.max[axis] + slack);
    }
    return planes;
}

std::size_t entries(const GridPlanes& planes, std::span<const Box> boxes) {
    std::size_t sum = 0;
    for (const Box& box : boxes) sum += planes.reached(box).size();
    return sum;
}

}  // namespace

std::size_t GridPlanes::cell_count() const {
    return exist() ? static_cast<std::size_t>(cells(0)) * static_cast<std::size_t>(cells(1)) *
                         static_cast<std::size_t>(cells(2))
                   : 0;
}

std::size_t GridPlanes::index(const Cell& cell) const {
    const auto in = [&](std::size_t axis) { return static_cast<std::size_t>(cell[axis]); };
    return in(0) + static_cast<std::size_t>(cells(0)) * (in(1) + static_cast<std::size_t>(cells(1)) * in(2));
}

Cell GridPlanes::cell(std::size_t index) const {
    const auto x = static_cast<std::size_t>(cells(0)), y = static_cast<std::size_t>(cells(1));
    return {static_cast<int>(index % x), static_cast<int>(index / x % y), static_cast<int>(index / (x * y))};
}

std::size_t GridPlanes::bytes() const {
    std::size_t sum = 0;
    for (const auto& planes : along) sum += planes.capacity() * sizeof(double);
    return sum;
}

int GridPlanes::cell_at(int axis, double coordinate) const {
    const auto& planes = along[static_cast<std::size_t>(axis)];
    const auto above = std::upper_bound(planes.begin() + 1, planes.end() - 1, coordinate);
    return static_cast<int>(above - planes.begin()) - 1;
}

Box GridPlanes::bounds(const Cell& cell) const {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)]);
        box.min[axis] = cast<float>(along[static_cast<std::size_t>(axis)][k]);
        box.max[axis] = cast<float>(along[static_cast<std::size_t>(axis)][k + 1]);
    }
    return box;
}

BoxOfDoubles GridPlanes::grown(const Cell& cell) const {
    BoxOfDoubles box{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto* planes = along[static_cast<std::size_t>(axis)].data() + cell[static_cast<std::size_t>(axis)];
        box.center[axis] = planes[0] / 2 + planes[1] / 2;
        box.half[axis] = planes[1] / 2 - planes[0] / 2 + 2 * slack;
    }
    return box;
}

std::size_t GridPlanes::Range::size() const {
    std::size_t product = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) product *= static_cast<std::size_t>(last[axis] - first[axis] + 1);
    return product;
}

GridPlanes::Range GridPlanes::reached(const Box& box) const {
    Range range{};
    for (int axis = 0; axis < 3; ++axis) {
        range.first[static_cast<std::size_t>(axis)] = cell_at(axis, box.min[axis] - slack);
        range.last[static_cast<std::size_t>(axis)] = cell_at(axis, box.max[axis] + slack);
    }
    return range;
}

GridPlanes grid_planes(std::span<const Box> boxes, double density) {
    if (boxes.empty()) return {};
    Box all;
    for (const Box& box : boxes) all = unite(all, box);
    const std::size_t largest = max_cells_or_entries(boxes.size());
    const double count = std::min(density * static_cast<double>(boxes.size()), static_cast<double>(largest));
    double side = cell_side(all, std::max(1.0, count));
    GridPlanes planes = cut(all, side);
    while (planes.exist() && planes.cell_count() > 1 && entries(planes, boxes) > largest) {
        side *= 2;
        planes = cut(all, side);
    }
    return planes;
}

}  // namespace raylab
