#pragma once

#include "polygon_workloads.h"

#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"

namespace raylab {

/// The oracle's answers to a workload, by this many threads (0: all cores).
Truth truth_of(const TriangleWorkload& workload, int threads);
Truth truth_of(const PolygonWorkload& workload, int threads);

}  // namespace raylab
