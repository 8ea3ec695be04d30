#pragma once

#include "raylab/report/chapter.h"

#include <vector>

namespace raylab::shadows {

/// Where feelers go wrong: ACNE, CONTACT, FAR-EYE, SKIP-ALONE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::shadows
