#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::coherence {

/// Cases in which a z-buffer and rays differ: ITEM-EDGE, ITEM-DEPTH, ITEM-BEHIND.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::coherence
