#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"

namespace raylab::lighting {

/// The ellipsoid of two_way_surfaces(), with its normals as colours: by the gradient, by the tangents, by three points
/// of a coarse grid.
Image draw_three_normals(const ChapterRun& run);

}  // namespace raylab::lighting
