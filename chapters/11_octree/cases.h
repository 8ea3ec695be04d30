#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::octrees {

/// Cases in which the traversal of octrees goes wrong: CELL-FACE, NEXT-CELL, HIT-OUTSIDE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::octrees
