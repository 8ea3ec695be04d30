#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/camera.h"

#include <cstdint>
#include <vector>

namespace raylab::ray_generation {

/// The question "How much of this pixel does that triangle cover?".
struct PixelQuery {
    std::uint32_t triangle;
    int x, y;
};
using Coverage = Workload<Triangle, PixelQuery>;

CameraFrame coverage_camera();

/// Pixels that an edge crosses (for one all in or all out the answer is trivial): of slanted edges, of level ones, of
/// slivers.
std::vector<Coverage> coverage_workloads(const ChapterRun& run);

/// The exact answer to each query: the area of the triangle's picture, clipped to the pixel.
std::vector<double> true_coverages(const Coverage& workload);

}  // namespace raylab::ray_generation
