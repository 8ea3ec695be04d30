#pragma once

#include "raylab/experiment/structure/structure_method.h"
#include "raylab/experiment/textbook/textbook_octree.h"

namespace raylab::octrees {

/// An octree that is traversed as in textbooks.
StructureMethod textbook(const std::string& name, const std::string& number,
                         const TextbookOctree::NextPoint& next_point,
                         TextbookOctree::End end = TextbookOctree::End::at_hit_in_leaf);

/// The lab's octrees, built in other ways.
StructureMethod octree_by_points(const std::string& name, const OctreeLimits& limits = {});
StructureMethod octree_by_names(const std::string& name, const OctreeLimits& limits = {});
StructureMethod octree_by_times(const std::string& name, const OctreeLimits& limits = {});
StructureMethod octree_by_blocks(const std::string& name, const OctreeLimits& limits = {});

}  // namespace raylab::octrees
