#include "grid_facts.h"

#include "raylab/accelerator/grid/grid.h"

#include <fmt/format.h>

namespace raylab::grids {

std::vector<std::string> facts_header() { return {"primitives", "cells", "entries in their lists"}; }

std::vector<std::vector<std::string>> facts_rows(const Scene& scene) {
    const Grid grid(scene);
    const GridPlanes& planes = grid.planes();
    return {{std::to_string(grid.primitives()),
             fmt::format("{} x {} x {}", planes.cells(0), planes.cells(1), planes.cells(2)),
             std::to_string(grid.entries())}};
}

StructureMethod cached_grid(double density) {
    return {"grid with a cache", "exact", [density](const Scene& scene) {
                return std::make_unique<Grid>(scene,
                                              GridOptions{.density = density, .mailboxes = MailboxKind::small_cache});
            }};
}

}  // namespace raylab::grids
