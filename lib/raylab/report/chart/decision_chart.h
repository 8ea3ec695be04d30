#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/plane/plane_drawing.h"

namespace raylab {

/// Draws how often methods decide wrongly, and how fast they are: a heat table, methods by workloads, and beside it, in
/// the same rows, a strip of times with a mark for each workload. The best methods come first. In each column the cells
/// of the Pareto front are framed, and a bracket joins those that are as fast as its fastest.
PlaneDrawing decision_chart(const Experiment& experiment);

}  // namespace raylab
