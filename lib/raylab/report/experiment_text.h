#pragma once

#include "raylab/experiment/measure/measure.h"

#include <string>

// An experiment for a terminal.

namespace raylab {

/// The answer, the question, and a line for each of the best methods: 25 lines at most.
std::string summary_text(const Experiment& experiment);

/// The answer, the question, and a line for each measurement.
std::string rows_text(const Experiment& experiment);

}  // namespace raylab
