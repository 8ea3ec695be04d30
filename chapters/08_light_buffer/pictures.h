#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The chapter's pictures, in the order of its story.

namespace raylab::lantern {

/// The scene, with its shadow rays through a light buffer that misses nothing.
Image shaded(const Scene& scene, const ChapterRun& run);

/// The scene with cells that list only what their central ray hits.
Image shaded_by_centers(const Scene& scene, int resolution, const ChapterRun& run);

/// The six faces of the light's cube, unfolded: the scene as seen from the light.
Image seen_by_light(const Scene& scene, const ChapterRun& run);

/// The number of primitives that each cell lists, on the unfolded cube.
Image cell_lists(const Scene& scene, int resolution, const ChapterRun& run);

/// The scene from above: the cells about the light, and one of them with the primitives that it lists and a shadow ray
/// in it.
PlaneDrawing draw_cell(const Scene& scene);

/// The list of that cell: the table's header, and a row for each primitive, the nearest first.
std::vector<std::string> cell_header();
std::vector<std::vector<std::string>> cell_rows(const Scene& scene);

/// Tests of boxes and primitives for the shadow rays of each pixel: through a tree, and through a light buffer.
Image shadow_ray_costs(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::lantern
