#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::transforms {

/// Cases in which transforms fail: NORMAL-SHEAR, MIRROR, UNIT-AGAIN, FAR-INSTANCE, FLAT-INSTANCE, TINY-INSTANCE,
/// SINGULAR.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::transforms
