#pragma once

#include "raylab/accelerator/octree_cells.h"
#include "raylab/accelerator/point_in_next_cell.h"
#include "raylab/report/structure_method.h"

#include <functional>

namespace raylab::octrees {

/// How a textbook's walk goes on: from a leaf to a point in the next, in units of the smallest cells.
using NextPoint =
    std::function<Vec3d(const OctreeCube& leaf, double smallest, const Vec3d& origin, const Vec3d& direction)>;

/// The t at which a ray leaves a cube.
double exit_of(const OctreeCube& cube, const Vec3d& origin, const Vec3d& direction);

/// When it ends.
enum class End { at_hit_in_leaf, at_first_hit };

/// An octree as textbooks walk it: from point to point, each looked up from the root, without a bound for any rounding.
StructureMethod textbook(const std::string& name, const std::string& number, NextPoint next_point,
                         End end = End::at_hit_in_leaf);

/// The lab's octrees, built otherwise.
StructureMethod octree_by_points(const std::string& name, const OctreeLimits& limits = {});
StructureMethod octree_by_names(const std::string& name, const OctreeLimits& limits = {});
StructureMethod octree_by_blocks(const std::string& name, const OctreeLimits& limits = {});

}  // namespace raylab::octrees
