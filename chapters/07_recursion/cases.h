#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::recursion {

/// Where refraction fails: TIR-EDGE, GRAZING.
std::vector<StabilityCase> refraction_cases(const ChapterRun& run);

/// Where recursion must stop, in rooms whose truth is known: HALL-OF-MIRRORS, PANES, RAY-BOMB.
std::vector<StabilityCase> room_cases();

}  // namespace raylab::recursion
