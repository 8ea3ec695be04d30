#pragma once

#include "raylab/experiment/measure/measure.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

// An experiment as data: its files, and the selections that charts and pages need.

namespace raylab {

std::string to_csv(const Experiment& experiment);
nlohmann::ordered_json to_json(const Experiment& experiment);

/// A table for a terminal, with one line for each measurement.
std::string to_text(const Experiment& experiment);

/// The experiment's workloads, in the order of their first measurement.
std::vector<std::string> workloads_of(const Experiment& experiment);

/// The experiment's method names, whatever number type they compute in, in the order of their first measurement.
std::vector<std::string> methods_of(const Experiment& experiment);

/// The indices of the measurements of one workload, in the order of `rows`.
std::vector<std::size_t> rows_of(const Experiment& experiment, const std::string& workload);

/// The indices of those that no other measurement of the workload beats in both error and time.
std::vector<std::size_t> front_of(const Experiment& experiment, const std::string& workload);

/// The title of a measurement: "Moeller-Trumbore, float", with the knob where there is one.
std::string title_of(const Measurement& row);

/// "0 (< 30)" where no error was seen, with its 95 % bound; "12.3" otherwise.
std::string error_text(const Measurement& row);

}  // namespace raylab
