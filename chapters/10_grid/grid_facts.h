#pragma once

#include "raylab/experiment/structure/structure_method.h"

#include <array>
#include <cstddef>

// Facts about a grid that its common interface does not tell.

namespace raylab::grids {

struct GridFacts {
    std::size_t primitives = 0, cells = 0, entries = 0;  // entries: primitives, summed over all cells' lists
    std::array<int, 3> along{};                          // cells along each axis
};
GridFacts grid_facts(const Scene& scene);

/// The grid with mailboxes that are a small cache of a ray's last primitives.
StructureMethod cached_grid(double density);

}  // namespace raylab::grids
