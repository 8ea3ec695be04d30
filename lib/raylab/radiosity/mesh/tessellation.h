#pragma once

#include "raylab/geometry/shapes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// A flat convex piece of a shape, before its transform.
struct FlatPiece {
    std::vector<Vec3d> corners;  // 3 or 4, counter-clockwise seen from the side of the normal
    std::uint32_t part = 0;      // of a mesh: its triangle; of a surface of revolution: its Part
    std::uint32_t smooth = 0;    // pieces of one number meet without an edge
};

/// A polygon of a shape, whole, and the pieces that it is made of: rays are asked of the whole, so that no ray slips
/// between two pieces of one plane.
struct FlatPolygon {
    std::vector<Vec3d> corners;
    std::vector<FlatPiece> pieces;
};

struct Tessellation {
    std::vector<FlatPolygon> polygons;
    double error = 0;  // the largest distance of a piece from the surface, in the shape's own metres
};

/// The flat polygons of a shape. Where it is curved their sides are at most `edge` long, and a ring has at least
/// twelve; corners lie on the surface. Its quadrilaterals lie in planes exactly: a ring's edge is parallel to the next
/// ring's.
Tessellation tessellation(const Shape& shape, double edge);

/// The number of its pieces before it is made, without the disks that close a surface of revolution.
std::size_t piece_count(const Shape& shape, double edge);

/// A simple polygon cut into triangles by clipping its ears. (Meisters: Polygons Have Ears, Amer. Math. Monthly 82(6),
/// 1975.) The result of a polygon that crosses itself is some of its triangles.
std::vector<std::vector<Vec3d>> triangulated(const std::vector<Vec3d>& polygon);

}  // namespace raylab
