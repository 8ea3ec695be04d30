#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

namespace raylab::grids {

/// The scene as the camera has it: by the first hit.
Image seen(const Scene& scene, const ChapterRun& run);

/// From above: a ray through the cells of the grid, numbered.
Image ray_through_cells(const Scene& scene);

/// Tests a pixel, and cells, for coarse and fine grids: one scale of colours for each row.
Image tests_a_pixel(const Scene& scene, const ChapterRun& run);
Image cells_a_pixel(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::grids
