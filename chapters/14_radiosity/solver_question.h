#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter_run.h"

namespace raylab::cornell {

/// How long each solver takes to which error, of the Cornell box and of a room of white walls.
Experiment measure_solvers(const ChapterRun& run);

}  // namespace raylab::cornell
