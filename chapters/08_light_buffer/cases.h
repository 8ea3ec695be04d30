#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::lantern {

/// Cases in which light buffers go wrong: LIGHT-CELL, LIGHT-INSIDE, LIGHT-MOVED.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::lantern
