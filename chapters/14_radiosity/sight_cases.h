#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab::cornell {

/// Cases about what is seen: by a patch through its centre, and by an eye that looks at interpolated patches.
std::vector<StabilityCase> sight_cases(const ChapterRun& run);

}  // namespace raylab::cornell
