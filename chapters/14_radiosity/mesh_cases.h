#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab::cornell {

/// Cases in which a mesh fails: what is smaller than its patches, and where sizes meet.
std::vector<StabilityCase> mesh_cases(const ChapterRun& run);

}  // namespace raylab::cornell
