#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chapter.h"

// The chapter's questions, measured: methods x workloads against the oracle.

namespace raylab {

/// Does a ray hit a triangle? Measures wrong decisions against time.
Experiment ray_triangle(const ChapterRun& run);

/// Is a closed mesh closed? Measures rays from inside that hit nothing, or two triangles.
Experiment closed_mesh(const ChapterRun& run);

/// Does a ray hit a polygon? Measures wrong decisions against time.
Experiment ray_polygon(const ChapterRun& run);

/// How wrong is a colour that is interpolated with u and v?
Experiment interpolation(const ChapterRun& run);

}  // namespace raylab
