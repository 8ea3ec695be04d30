#pragma once

#include "raylab/experiment/structure/structure_method.h"

#include <string>
#include <vector>

// Facts about a grid that its common interface does not tell.

namespace raylab::grids {

/// The scene's primitives, the cells along each axis, and the entries of all cells' lists.
std::vector<std::string> facts_header();
std::vector<std::vector<std::string>> facts_rows(const Scene& scene);

/// The grid with mailboxes that are a small cache of a ray's last primitives.
StructureMethod cached_grid(double density);

}  // namespace raylab::grids
