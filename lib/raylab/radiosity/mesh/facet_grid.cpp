#include "raylab/radiosity/mesh/facet_grid.h"

#include "raylab/geometry/dominant_axis.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

bool is_triangle(const Facet& facet) { return facet.corners.size() == 3; }

std::uint32_t pieces(double length, double edge) {
    constexpr double most = 1 << 20;
    return static_cast<std::uint32_t>(std::clamp(std::ceil(length / edge - 1e-9), 1.0, most));
}

double side(const Facet& facet, std::size_t i) {
    return glm::distance(facet.corners[i], facet.corners[(i + 1) % facet.corners.size()]);
}

Vec3d point_at(const Facet& facet, double u, double v) {
    const auto& c = facet.corners;
    if (is_triangle(facet)) return (1 - u - v) * c[0] + u * c[1] + v * c[2];
    return glm::mix(glm::mix(c[0], c[1], u), glm::mix(c[3], c[2], u), v);
}

/// A cell of a triangle's row: the 2(n - row) - 1 cells of a row stand upright and upside down by turns.
struct TriangleCell {
    std::uint32_t column, row;
    bool upside_down;
};

std::size_t first_of_row(std::uint32_t n, std::size_t row) { return row * (2 * std::size_t{n} - row); }

TriangleCell triangle_cell(std::uint32_t n, std::size_t cell) {
    std::uint32_t row = 0;
    while (first_of_row(n, row + 1) <= cell) ++row;
    const auto in_row = static_cast<std::uint32_t>(cell - first_of_row(n, row));
    return {in_row / 2, row, in_row % 2 == 1};
}

double cross_of(const std::array<double, 2>& a, const std::array<double, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }

// The parameters of a quadrilateral: two linear equations with one product, so a quadratic one for v. Of its two roots
// the one in [0, 1] is meant; a parallelogram has one.
FacetParameters quadrilateral_parameters(const std::array<double, 2>& e, const std::array<double, 2>& f,
                                         const std::array<double, 2>& g, const std::array<double, 2>& h) {
    const double k2 = cross_of(g, f), k1 = cross_of(e, f) + cross_of(h, g), k0 = cross_of(h, e);
    const double q = -0.5 * (k1 + std::copysign(std::sqrt(std::max(0.0, k1 * k1 - 4 * k0 * k2)), k1));
    const auto outside = [](double x) { return std::max({-x, x - 1, 0.0}); };
    const double small = q != 0 ? k0 / q : 0;
    const double large = k2 != 0 ? q / k2 : small;
    const double v = outside(large) < outside(small) ? large : small;
    const std::array<double, 2> across{e[0] + g[0] * v, e[1] + g[1] * v};
    const std::size_t axis = std::abs(across[0]) > std::abs(across[1]) ? 0 : 1;
    return {(h[axis] - f[axis] * v) / across[axis], v};
}

}  // namespace

FacetCells facet_cells(const Facet& facet, double edge) {
    if (is_triangle(facet)) {
        const auto n = pieces(std::max({side(facet, 0), side(facet, 1), side(facet, 2)}), edge);
        return {n, n};
    }
    return {pieces(std::max(side(facet, 0), side(facet, 2)), edge),
            pieces(std::max(side(facet, 1), side(facet, 3)), edge)};
}

std::size_t cell_count(const FacetCells& cells) {
    return std::size_t{cells.columns} * cells.rows;  // 1 + 3 + ... + (2n - 1) is n^2
}

std::vector<Vec3d> cell_corners(const Facet& facet, const FacetCells& cells, std::size_t cell) {
    const auto corner = [&](std::uint32_t i, std::uint32_t j) {
        return point_at(facet, static_cast<double>(i) / cells.columns, static_cast<double>(j) / cells.rows);
    };
    if (is_triangle(facet)) {
        const auto [i, j, upside_down] = triangle_cell(cells.rows, cell);
        if (upside_down) return {corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
        return {corner(i, j), corner(i + 1, j), corner(i, j + 1)};
    }
    const auto i = static_cast<std::uint32_t>(cell % cells.columns),
               j = static_cast<std::uint32_t>(cell / cells.columns);
    return {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
}

FacetParameters facet_parameters(const Facet& facet, const Vec3d& point) {
    const auto& c = facet.corners;
    const Vec3d normal = cross(c[1] - c[0], c.back() - c[0]);
    const int axis = dominant_axis(normal);
    const auto flat = [&](const Vec3d& p) { return std::array<double, 2>{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
    const auto h = flat(point - c[0]), e = flat(c[1] - c[0]), f = flat(c.back() - c[0]);
    if (is_triangle(facet)) {
        const double area = cross_of(e, f);
        return {cross_of(h, f) / area, cross_of(e, h) / area};
    }
    return quadrilateral_parameters(e, f, flat(c[0] - c[1] + c[2] - c[3]), h);
}

double distance_outside(const FacetParameters& at, const Facet& facet) {
    const double beyond = is_triangle(facet) ? at.u + at.v - 1 : std::max(at.u, at.v) - 1;
    return std::max({-at.u, -at.v, beyond, 0.0});
}

CellPlace cell_at(const Facet& facet, const FacetCells& cells, const FacetParameters& at) {
    const auto split = [](double share, std::uint32_t count) {
        const double place = std::clamp(share, 0.0, 1.0) * count;
        const double cell = std::min(std::floor(place), count - 1.0);
        return std::pair{static_cast<std::uint32_t>(cell), place - cell};
    };
    auto [i, s] = split(at.u, cells.columns);
    auto [j, t] = split(at.v, cells.rows);
    if (!is_triangle(facet)) return {j * cells.columns + i, {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}};
    if (i + j >= cells.rows) {  // beyond the long side, by rounding
        i = cells.rows - 1 - std::min(j, cells.rows - 1);
        s = std::clamp(1 - t, 0.0, 1.0);
    }
    const bool upside_down = s + t > 1 && i + j + 1 < cells.rows;
    const auto cell = static_cast<std::uint32_t>(first_of_row(cells.rows, j)) + 2 * i + (upside_down ? 1 : 0);
    if (upside_down) return {cell, {1 - t, s + t - 1, 1 - s, 0}};
    const double over = std::max(s + t, 1.0);
    return {cell, {1 - (s + t) / over, s / over, t / over, 0}};
}

}  // namespace raylab
