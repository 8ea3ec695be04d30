#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <array>

namespace raylab {

/// A triangle's vertex at its place.
struct Corner {
    Vec3d position, normal;  // normal: unit
};

/// The corners of a placed mesh's triangle, whose own unit normal stands in where a vertex has none. The mesh has
/// normals.
std::array<Corner, 3> mesh_corners(const Mesh& mesh, std::size_t face, const Affine& placement,
                                   const Vec3d& face_normal);

/// The unit normal between those of the triangle's corners, u the weight of the second and v of the third; the
/// triangle's own where they cancel. The mesh has normals.
Vec3d normal_between(const Mesh& mesh, std::size_t face, double u, double v, const Affine& placement,
                     const Vec3d& face_normal);

}  // namespace raylab
