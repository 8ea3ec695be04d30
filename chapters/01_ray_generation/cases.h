#pragma once

#include "raylab/report/chapter.h"

namespace raylab::ray_generation {

/// UP-PARALLEL, FOV-LIMITS, EYE-AT-TARGET, CAMERA-SCALE, FAR-CAMERA: what camera_frame() refuses, and what it holds
/// where the formulas in float do not.
std::vector<StabilityCase> camera_cases();

/// Those, HALF-PIXEL, PINHOLE, BOTH-WAYS and SAMPLE-SLOPE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::ray_generation
