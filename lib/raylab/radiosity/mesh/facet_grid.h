#pragma once

#include "raylab/radiosity/mesh/polygonal_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// A facet as a grid of cells: a quadrilateral has columns x rows of them, a triangle n rows of triangles, 2n - 1 in the
// first and 1 in the last.

namespace raylab {

struct FacetCells {
    std::uint32_t columns, rows;  // of a triangle both are n
};

/// As few cells as leave no side of one longer than `edge`.
FacetCells facet_cells(const Facet& facet, double edge);

std::size_t cell_count(const FacetCells& cells);

/// The corners of a cell, counter-clockwise seen from the front.
std::vector<Vec3d> cell_corners(const Facet& facet, const FacetCells& cells, std::size_t cell);

/// Where a point of a facet lies: of a quadrilateral a b c d it is (1-u)(1-v) a + u(1-v) b + uv c + (1-u)v d, of a
/// triangle (1-u-v) a + u b + v c.
struct FacetParameters {
    double u, v;
};

FacetParameters facet_parameters(const Facet& facet, const Vec3d& point);

/// How far parameters lie outside of those of the facet's own points; 0 for these.
double distance_outside(const FacetParameters& at, const Facet& facet);

/// One of the facets of a scene, and a place on it.
struct FacetPlace {
    std::uint32_t facet;
    FacetParameters at;
};

/// The cell of a place, and the weights of the cell's corners there. Places outside count as the nearest one inside.
struct CellPlace {
    std::uint32_t cell;
    std::array<double, 4> weights;
};

CellPlace cell_at(const Facet& facet, const FacetCells& cells, const FacetParameters& at);

}  // namespace raylab
