#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::lighting {

/// Cases in which local lighting fails: errors of lights and highlights, of meshes, and effects that no local model can
/// show.
std::vector<StabilityCase> cases(const ChapterRun& run);

std::vector<StabilityCase> light_cases(const ChapterRun& run);
std::vector<StabilityCase> mesh_cases(const ChapterRun& run);
std::vector<StabilityCase> local_cases(const ChapterRun& run);

}  // namespace raylab::lighting
