#pragma once

#include "raylab/report/chapter.h"

namespace raylab::transforms {

/// "Where does a ray hit a placed sphere?": wrong decisions against nanoseconds.
Experiment measure_placed_sphere(const ChapterRun& run);

/// "What is the normal of a placed surface?": the worst angle against nanoseconds.
Experiment measure_transformed_normal(const ChapterRun& run);

}  // namespace raylab::transforms
