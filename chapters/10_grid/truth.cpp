#include "walks.h"

#include <algorithm>
#include <cmath>

// In units of 2^-20 all planes, origins and directions are integers below 2^23, so every t is a fraction, and two
// fractions are compared by products below 2^46: nothing is rounded.

namespace raylab::grids {

namespace {

using Whole = std::int64_t;

struct Fraction {
    Whole over, under;  // under > 0

    friend Whole compare(const Fraction& a, const Fraction& b) { return a.over * b.under - b.over * a.under; }
};

Fraction t_of(const LatticeRay& ray, std::size_t axis, Whole plane) {
    const Whole d = ray.direction[axis], way = plane - ray.origin[axis];
    return d > 0 ? Fraction{way, d} : Fraction{-way, -d};
}

Whole plane_ahead(const LatticeRay& ray, std::size_t axis, Whole cell, Whole side) {
    return (cell + (ray.direction[axis] > 0 ? 1 : 0)) * side;
}

}  // namespace

CubeOfCells cube_of_cells(int n) {
    CubeOfCells cube{n, {}};
    cube.planes.slack = 0x1p-16 / n;
    for (auto& along : cube.planes.along) {
        for (int k = 0; k <= n; ++k) along.push_back(static_cast<double>(k) / n);
        along.front() -= cube.planes.slack;
        along.back() += cube.planes.slack;
    }
    return cube;
}

Ray in_floats(const LatticeRay& ray) {
    Ray result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result.origin[static_cast<int>(axis)] = std::ldexp(static_cast<float>(ray.origin[axis]), -20);
        result.direction[static_cast<int>(axis)] = std::ldexp(static_cast<float>(ray.direction[axis]), -20);
    }
    return result;
}

CellNumber number_of(std::int64_t x, std::int64_t y, std::int64_t z, const CubeOfCells& cube) {
    const auto n = static_cast<CellNumber>(cube.n);
    return static_cast<CellNumber>(x) + n * (static_cast<CellNumber>(y) + n * static_cast<CellNumber>(z));
}

std::optional<std::vector<CellNumber>> cells_in_truth(const LatticeRay& ray, const CubeOfCells& cube) {
    const Whole side = lattice_one / cube.n;
    Fraction enter{0, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Fraction t = t_of(ray, axis, ray.direction[axis] > 0 ? 0 : lattice_one);
        if (compare(t, enter) > 0) enter = t;
    }
    std::array<Whole, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // The number of planes behind the point of entry: those with a smaller t.
        const bool forward = ray.direction[axis] > 0;
        const auto is_behind = [&](Whole k) { return compare(t_of(ray, axis, k * side), enter) <= 0; };
        Whole low = 0, high = cube.n;  // going forward planes 0 .. low are behind; going backward, planes high .. n
        while (high - low > 1) {
            const Whole middle = (low + high) / 2;
            (is_behind(middle) == forward ? low : high) = middle;
        }
        cell[axis] = low;
        // The ray misses the cube.
        if (compare(t_of(ray, axis, forward ? lattice_one : 0), enter) <= 0) return std::vector<CellNumber>{};
        const Whole edge = forward ? low : high;
        if (edge > 0 && edge < cube.n && compare(t_of(ray, axis, edge * side), enter) == 0) return std::nullopt;
    }
    std::vector<CellNumber> cells;
    while (std::ranges::all_of(cell, [&](Whole c) { return c >= 0 && c < cube.n; })) {
        cells.push_back(number_of(cell[0], cell[1], cell[2], cube));
        std::array<Fraction, 3> t{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            t[axis] = t_of(ray, axis, plane_ahead(ray, axis, cell[axis], side));
        std::size_t first = 0;
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (compare(t[axis], t[first]) < 0) first = axis;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (axis != first && compare(t[axis], t[first]) == 0) return std::nullopt;
        cell[first] += ray.direction[first] > 0 ? 1 : -1;
    }
    return cells;
}

}  // namespace raylab::grids
