#pragma once

#include "raylab/experiment/structure/structure_method.h"

#include <vector>

namespace raylab::volumes {

/// Trees of boxes that are split at the median, by cost in bins, by cost everywhere.
std::vector<StructureMethod> cuts();

/// A tree split at the median until a leaf has at most this many.
StructureMethod down_to(std::size_t largest_leaf);

/// Trees of boxes with box tests that lose rays, or might: each has the name of its test.
std::vector<StructureMethod> weak_trees();

/// The tree of boxes as textbooks traverse it: in doubles, without any error bound
/// (experiment/textbook/textbook_bvh.h).
StructureMethod textbook_tree(const std::string& name);

}  // namespace raylab::volumes
