#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::recursion {

/// Where recursion fails: TIR-EDGE, GRAZING, HALL-OF-MIRRORS, PANES, RAY-BOMB.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::recursion
