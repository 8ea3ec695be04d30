#pragma once

#include "raylab/report/chart/chart.h"
#include "raylab/report/chart/gnuplot.h"

namespace raylab {

/// Draws curves: each is named at its right end, and they differ in colour and marker.
GnuplotDrawing curve_drawing(const CurveChart& chart);

}  // namespace raylab
