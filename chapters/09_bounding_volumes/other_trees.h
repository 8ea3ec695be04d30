#pragma once

#include "raylab/report/structure/structure_method.h"

#include <vector>

namespace raylab::volumes {

/// Boxes cut at the median, by cost in bins, by cost everywhere.
std::vector<StructureMethod> cuts();

/// Cut at the median until so many are left.
StructureMethod down_to(std::size_t largest_leaf);

/// The tree of boxes with box tests that lose rays, or might: the name is the test's.
std::vector<StructureMethod> weak_trees();

}  // namespace raylab::volumes
