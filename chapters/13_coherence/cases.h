#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::coherence {

/// Where a z-buffer and the rays differ: ITEM-EDGE, ITEM-DEPTH, ITEM-BEHIND.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::coherence
