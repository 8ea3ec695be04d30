#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::recursion {

/// Cases in which refraction fails: TIR-EDGE, GRAZING.
std::vector<StabilityCase> refraction_cases(const ChapterRun& run);

/// Cases of when recursion must stop, in rooms whose exact colours are known: HALL-OF-MIRRORS, PANES, RAY-BOMB.
std::vector<StabilityCase> room_cases(const ChapterRun& run);

}  // namespace raylab::recursion
