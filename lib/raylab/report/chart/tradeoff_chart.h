#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/plane/plane_drawing.h"

namespace raylab {

/// Draws speed against accuracy: a panel for each workload, with common axes, and the Pareto front as steps. A single
/// panel names its points beside them; several name those of the front, and a legend below tells the methods apart.
PlaneDrawing tradeoff_chart(const Experiment& experiment);

}  // namespace raylab
