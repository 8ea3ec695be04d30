#pragma once

#include "raylab/report/chart/gnuplot.h"
#include "raylab/report/measure.h"

namespace raylab {

/// Speed against accuracy as a drawing: a panel a workload, axes in common, the Pareto front as steps. One panel names
/// its points beside them; several name the front's, and a strip below tells the methods apart.
GnuplotDrawing tradeoff_drawing(const Experiment& experiment);

}  // namespace raylab
