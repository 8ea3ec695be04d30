#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter_run.h"
#include "raylab/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

// A scene for which no size of cells is right: a teapot in a stadium.

namespace raylab::grids {

/// A knot of many small triangles in the middle of a stadium of few large ones, `wide` times as large.
Scene knot_in_stadium(int levels, float wide);
std::shared_ptr<const Scene> stadium_scene(const ChapterRun& run);

/// The cells that hold something, from above, and the middle of them enlarged. They are too many for an SVG.
Image draw_stadium(const Scene& scene);

/// The costs of grids and of a hierarchy for a ray of the camera.
std::vector<std::string> stadium_header();
std::vector<std::vector<std::string>> stadium_rows(const std::shared_ptr<const Scene>& scene, const ChapterRun& run);

}  // namespace raylab::grids
