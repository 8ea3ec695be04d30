#pragma once

#include "raylab/report/measure.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

// An experiment as data: its files, and what charts and pages need to know of it.

namespace raylab {

std::string to_csv(const Experiment& experiment);
nlohmann::ordered_json to_json(const Experiment& experiment);

/// A table for a terminal, one line a measurement.
std::string to_text(const Experiment& experiment);

/// The experiment's workloads, in the order of their first measurement.
std::vector<std::string> workloads_of(const Experiment& experiment);

/// The experiment's method names (whatever number they compute in), in the order of their first measurement.
std::vector<std::string> methods_of(const Experiment& experiment);

/// The indices of the measurements of one workload, as they stand in `rows`.
std::vector<std::size_t> rows_of(const Experiment& experiment, const std::string& workload);

/// Those of them that no other beats in both error and time.
std::vector<std::size_t> front_of(const Experiment& experiment, const std::string& workload);

/// "Moeller-Trumbore, float", with the knob where there is one.
std::string title_of(const Measurement& row);

/// "0 (< 30)" where no error was seen, with its 95 % bound; "12.3" otherwise.
std::string error_text(const Measurement& row);

}  // namespace raylab
