#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/scene/scene.h"

#include <vector>

namespace raylab::grids {

/// The scene from its camera, with the first hits only.
Image seen(const Scene& scene, const ChapterRun& run);

/// A ray over the table from above, as it goes through the numbered cells of the grid.
PlaneDrawing ray_through_cells(const Scene& scene);

/// The densities of coarse and fine grids, as in the names of the pictures.
inline constexpr int densities[] = {1, 8, 64};

/// This cost of each pixel, a map for each density.
std::vector<CostMap> cost_maps(const Scene& scene, Cost cost, const ChapterRun& run);

/// One of them as a picture, in the same colours as the others.
Image heated(const std::vector<CostMap>& maps, std::size_t which, Cost cost);

}  // namespace raylab::grids
