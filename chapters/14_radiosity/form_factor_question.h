#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter_run.h"

namespace raylab::cornell {

/// How much of a square's light arrives at another? Measures the relative error of every method against its time, with
/// squares that are far apart, near, and that share an edge.
Experiment measure_form_factors(const ChapterRun& run);

}  // namespace raylab::cornell
