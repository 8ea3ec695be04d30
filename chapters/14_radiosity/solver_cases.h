#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab::cornell {

/// Cases in which linear systems of form factors go wrong: RADIOSITY-BLOWUP, OPEN-SCENE.
std::vector<StabilityCase> solver_cases(const ChapterRun& run);

}  // namespace raylab::cornell
