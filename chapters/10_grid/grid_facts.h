#pragma once

#include "raylab/report/structure/structure_method.h"

#include <array>
#include <cstddef>

// What a chapter needs to know of a grid beyond the seam.

namespace raylab::grids {

struct GridFacts {
    std::size_t primitives = 0, cells = 0, entries = 0;  // entries: primitives over all cells' lists
    std::array<int, 3> along{};                          // cells along each axis
};
GridFacts grid_facts(const Scene& scene);

/// The grid that remembers a ray's last primitives in a small cache.
StructureMethod cached_grid(double density);

}  // namespace raylab::grids
