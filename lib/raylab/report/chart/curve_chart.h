#pragma once

#include "raylab/report/chart/chart.h"
#include "raylab/report/chart/gnuplot.h"

namespace raylab {

/// Curves as a drawing: each named at its right end, told apart by colour and marker.
GnuplotDrawing curve_drawing(const CurveChart& chart);

}  // namespace raylab
