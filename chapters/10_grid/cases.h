#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::grids {

/// Where grids go wrong: DDA-DRIFT, MAILBOX, STADIUM.
std::vector<StabilityCase> cases(const ChapterRun& run);

/// The question "grid_hits": our grids and the textbook's, judged by the list.
Experiment measure_grid_hits(const ChapterRun& run);

}  // namespace raylab::grids
