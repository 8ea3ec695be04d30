#pragma once

#include "raylab/experiment/measure/measure.h"

#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// A method of an experiment with its measurements: a line of a table.
struct MethodRows {
    std::string name;    // name_of() its measurements
    std::string method;  // Measurement::method
    // For each of workloads_of(): the index in Experiment::rows; absent where it was not measured.
    std::vector<std::optional<std::size_t>> rows;
    double worst_error;  // on any workload
    double slowness;     // its time as a multiple of the fastest method's: the geometric mean over its workloads

    bool everywhere() const;  // whether it was measured on every workload
};

/// The methods of an experiment, the best first: by their worst error, then by their slowness.
std::vector<MethodRows> methods_in_order(const Experiment& experiment);

}  // namespace raylab
