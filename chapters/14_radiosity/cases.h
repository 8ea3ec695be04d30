#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab::cornell {

/// The cases in which methods of this chapter fail.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::cornell
