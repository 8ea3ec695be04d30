#pragma once

#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The chapter's tables.

namespace raylab::lighting {

using Rows = std::vector<std::vector<std::string>>;

/// README (1), (4) and (5) at one point of the scene's shiny ball, under its point light.
Rows worked_point_rows(const Scene& scene);

/// The worst angle between the normals of two-way surfaces, by tangents and by three points, and the gradient's.
std::vector<std::string> normals_header();
Rows normals_rows(const ChapterRun& run);

}  // namespace raylab::lighting
