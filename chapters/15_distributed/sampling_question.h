#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter_run.h"

namespace raylab::spread {

/// The error of a picture against the time for one of its pixels, for every sampler and effect, over 20 seeds; times
/// are medians over three of them, on one thread. The truth is a picture of 16 times as many samples, so the error of
/// the best is a few per cent off.
Experiment measure_sampling(const ChapterRun& run);

}  // namespace raylab::spread
