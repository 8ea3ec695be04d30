#pragma once

#include "raylab/report/chapter.h"

namespace raylab::ray_generation {

/// UP-PARALLEL, FOV-LIMITS, EYE-AT-TARGET, CAMERA-SCALE, FAR-CAMERA: cameras that camera_frame() refuses, and cameras
/// for which it is accurate where the formulas in float are not.
std::vector<StabilityCase> camera_cases();

/// camera_cases(), HALF-PIXEL, PINHOLE, BOTH-WAYS and SAMPLE-SLOPE.
std::vector<StabilityCase> cases(const ChapterRun& run);

}  // namespace raylab::ray_generation
