#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

namespace raylab::grids {

/// The scene from its camera, with the first hits only.
Image seen(const Scene& scene, const ChapterRun& run);

/// The ray that the chapter follows.
inline const Ray ray_over_the_table{{-4.4f, 0.62f, 2.3f}, {1, -0.06f, -0.45f}};

/// The ray from above, as it goes through the numbered cells of the grid.
Image ray_through_cells(const Scene& scene);

/// Tests for each pixel, and cells, for coarse and fine grids; each row has one scale of colours.
Image tests_a_pixel(const Scene& scene, const ChapterRun& run);
Image cells_a_pixel(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::grids
