#pragma once

#include "raylab/experiment/ray_triangle/methods.h"
#include "raylab/image/image.h"

#include <vector>

// Pictures in which neighbouring rays differ only in the last bit of a float.

namespace raylab {

/// What lies under the microscope: triangles that share an edge or a vertex, and the ray that is aimed at it.
struct Specimen {
    std::vector<Triangle> triangles;
    Ray ray;
};

/// Two triangles with a common edge, and the ray aimed at a point of it.
Specimen shared_edge();

/// Six triangles around one vertex, and the ray aimed at it.
Specimen shared_vertex();

/// `cells` x `cells` rays from one origin; each direction differs by one float from its neighbour's in x or in y. The
/// sign of each cell shows which triangles the method hits: one (a line whose slant tells which), several (a cross on
/// white), none (a ring on black: light leaks).
Image microscope(const TriangleMethod& method, const Specimen& specimen, int cells);

}  // namespace raylab
