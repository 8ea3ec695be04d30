#pragma once

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

// How large should a cell be? And a scene for which no size is right: a teapot in a stadium.

namespace raylab::grids {

/// A knot of many small triangles in the middle of a stadium of few large ones, `bvh8` times as large.
Scene knot_in_stadium(int levels, float wide);

/// The cost of one structure for a camera ray.
struct CostPerRay {
    double tests = 0, box_tests = 0, steps = 0;
};
CostPerRay cost_per_ray(const std::string& accelerator, const StructureWorkload& workload);

/// Charts and a table of tests, steps, time and memory over the density of cells.
void tell_cell_sizes(const ChapterRun& run, Page& page);

/// The savings by both kinds of mailboxes.
void tell_mailboxes(const ChapterRun& run, Page& page);

/// The costs of the grid and of a hierarchy in the stadium.
void tell_stadium(const ChapterRun& run, Page& page);

}  // namespace raylab::grids
