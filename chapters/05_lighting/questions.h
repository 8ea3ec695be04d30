#pragma once

#include "raylab/report/chapter.h"

namespace raylab::lighting {

/// "How bright is a point of a mesh?": the error of flat, Gouraud and Phong shading against the exact surface, and the
/// time for a point, for growing numbers of triangles.
Experiment measure_mesh_shading(const ChapterRun& run);

/// "How bright is a highlight?": the worst error against nanoseconds.
Experiment measure_phong_specular(const ChapterRun& run);

}  // namespace raylab::lighting
