#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::split {

/// Cases in which trees of planes go wrong: SPLIT-PLANE, BEYOND-CELL, PAINTER.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::split
