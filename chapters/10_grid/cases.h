#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::grids {

/// Cases in which grids go wrong: DDA-DRIFT, MAILBOX, STADIUM.
std::vector<StabilityCase> cases(const ChapterRun& run);

/// The question "grid_hits": the lab's grids and the textbook's, compared with the list.
Experiment measure_grid_hits(const ChapterRun& run);

}  // namespace raylab::grids
