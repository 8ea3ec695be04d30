#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::octrees {

/// Where walks through octrees go wrong: CELL-FACE, NEXT-CELL, HIT-OUTSIDE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::octrees
