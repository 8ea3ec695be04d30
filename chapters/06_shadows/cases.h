#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::shadows {

/// Cases in which shadow rays go wrong: ACNE, CONTACT, FAR-EYE, SKIP-ALONE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::shadows
