#pragma once

#include "raylab/geometry/ray_triangle/methods.h"
#include "raylab/image/image.h"

#include <vector>

// Where floats are as coarse as pixels: a picture in which neighbouring rays differ in the last bit.

namespace raylab {

/// What lies under the microscope: triangles that share an edge or a vertex, and the ray aimed at it.
struct Specimen {
    std::vector<Triangle> triangles;
    Ray ray;
};

/// Two triangles with a common edge, the ray aimed at a point of it.
Specimen shared_edge();

/// Six triangles around one vertex, the ray aimed at it.
Specimen shared_vertex();

/// `cells` x `cells` rays from one origin, each direction one float further than its neighbour's in x or in y. The sign
/// of each cell says which triangles the method hits: one (a stroke, its slant tells which), several (a cross on
/// white), none (a ring on black: light leaks).
Image microscope(const TriangleMethod& method, const Specimen& specimen, int cells);

}  // namespace raylab
