#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The chapter's pictures, in the order of its story.

namespace raylab::lantern {

/// The scene, its feelers through a light buffer that misses nothing.
Image shaded(const Scene& scene, const ChapterRun& run);

/// ... through cells that list what their centre meets.
Image shaded_by_centers(const Scene& scene, int resolution, const ChapterRun& run);

/// The six faces of the lamp's cube, unfolded: what the lamp sees.
Image seen_by_lamp(const Scene& scene, const ChapterRun& run);

/// ... and how many primitives each cell lists.
Image cell_lists(const Scene& scene, int resolution, const ChapterRun& run);

/// The scene from above: the cells about the lamp, and one of them with what it lists, a feeler in it.
PlaneDrawing draw_cell(const Scene& scene);

/// What that cell lists: the table's header, and a row for each primitive, the nearest first.
std::vector<std::string> cell_header();
std::vector<std::vector<std::string>> cell_rows(const Scene& scene);

/// Tests of boxes and primitives for the feelers of each pixel: through a tree, and through a light buffer.
Image feeler_costs(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::lantern
