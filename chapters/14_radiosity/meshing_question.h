#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter_run.h"

namespace raylab::cornell {

/// How far the Cornell box's radiosities are wrong, by which mesh and in which time.
Experiment measure_meshing(const ChapterRun& run);

}  // namespace raylab::cornell
