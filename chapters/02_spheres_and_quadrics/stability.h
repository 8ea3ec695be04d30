#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab {

/// FAR-SPHERE, SILHOUETTE, SPHERE-FLOOR, TANGENT, INSIDE-START, ON-SURFACE, SPHERE-RANGE, QUADRIC-RIM, ...: where
/// methods for spheres and quadrics fail, and where others hold.
std::vector<StabilityCase> stability_cases(const ChapterRun& run);

}  // namespace raylab
