#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::volumes {

/// SLAB-NAN, SLAB-PAD, VOID-AREA, HOLES.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::volumes
