#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter.h"

// The chapter's three questions, measured: methods x workloads against the oracle.

namespace raylab {

/// Does a ray hit a sphere? Measures wrong decisions against time.
Experiment ray_sphere(const ChapterRun& run);

/// Where does a ray hit a sphere? Measures the error of t against time.
Experiment ray_sphere_t(const ChapterRun& run);

/// Does a ray hit an ellipsoid, a cylinder, a cone, a paraboloid, a hyperboloid? Measures wrong decisions against time.
Experiment ray_quadric(const ChapterRun& run);

}  // namespace raylab
