#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chart/sketch.h"

namespace raylab {

/// What a mark of a chart says of its measurement: method, workload, error, time, source; and the same as data for a
/// script: method, number, knob, workload, error, nanoseconds, queries, source.
MarkWords measurement_words(const Experiment& experiment, const Measurement& row);

}  // namespace raylab
