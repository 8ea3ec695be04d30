#pragma once

#include "polygon_workloads.h"

#include "raylab/report/wrong_decisions.h"
#include "raylab/sampling/ray_triangle_workloads.h"

namespace raylab {

/// The oracle's answers to a workload, from all threads (0) or some.
Truth truth_of(const TriangleWorkload& workload, int threads);
Truth truth_of(const PolygonWorkload& workload, int threads);

}  // namespace raylab
