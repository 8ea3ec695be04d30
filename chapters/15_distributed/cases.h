#pragma once

#include "raylab/report/chapter_run.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab::spread {

/// The cases in which ways to sample fail.
std::vector<StabilityCase> cases(const ChapterRun& run);

std::vector<StabilityCase> sampling_cases(const ChapterRun& run);  // how numbers are chosen
std::vector<StabilityCase> light_cases(const ChapterRun& run);     // how light is found
std::vector<StabilityCase> stopping_cases(const ChapterRun& run);  // when sampling stops

}  // namespace raylab::spread
