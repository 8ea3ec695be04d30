#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::lighting {

/// Where local lighting fails: what lights and highlights do, what meshes do to them, and what no local model can show.
std::vector<StabilityCase> cases(const ChapterRun& run);

std::vector<StabilityCase> light_cases(const ChapterRun& run);
std::vector<StabilityCase> mesh_cases(const ChapterRun& run);
std::vector<StabilityCase> local_cases(const ChapterRun& run);

}  // namespace raylab::lighting
