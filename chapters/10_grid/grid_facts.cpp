#include "grid_facts.h"

#include "raylab/accelerator/grid/grid.h"

namespace raylab::grids {

GridFacts grid_facts(const Scene& scene) {
    const Grid grid(scene);
    const GridPlanes& planes = grid.planes();
    return {
        grid.primitives(), planes.cell_count(), grid.entries(), {planes.cells(0), planes.cells(1), planes.cells(2)}};
}

StructureMethod cached_grid(double density) {
    return {"grid with a cache", "exact", [density](const Scene& scene) {
                return std::make_unique<Grid>(scene,
                                              GridOptions{.density = density, .mailboxes = MailboxKind::small_cache});
            }};
}

}  // namespace raylab::grids
