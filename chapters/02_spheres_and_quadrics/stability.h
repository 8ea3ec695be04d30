#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/stability.h"

#include <vector>

namespace raylab {

/// FAR-SPHERE, SILHOUETTE, SPHERE-FLOOR, TANGENT, INSIDE-START, ON-SURFACE, SPHERE-RANGE, QUADRIC-RIM, ...: cases in
/// which some methods for spheres and quadrics fail, and others hold.
std::vector<StabilityCase> stability_cases(const ChapterRun& run);

}  // namespace raylab
