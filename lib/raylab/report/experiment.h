#pragma once

#include "raylab/experiment/measure/measure.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

// An experiment as data: its files, and the selections that charts and pages need.

namespace raylab {

std::string to_csv(const Experiment& experiment);
nlohmann::ordered_json to_json(const Experiment& experiment);

/// The experiment's workloads, in the order of their first measurement.
std::vector<std::string> workloads_of(const Experiment& experiment);

/// The experiment's method names, whatever number type they compute in, in the order of their first measurement.
std::vector<std::string> methods_of(const Experiment& experiment);

/// The indices of the measurements of one workload, in the order of `rows`.
std::vector<std::size_t> rows_of(const Experiment& experiment, const std::string& workload);

/// Whether the errors are shares of wrong answers: the axis counts them in parts per million.
bool errors_are_shares(const Experiment& experiment);

/// A method that gives more wrong answers than this, in parts per million, is on no front, however fast it is.
constexpr double most_wrong_on_front = 10'000;

/// The indices of the measurements of a workload that no other beats, in time and error: its Pareto front.
std::vector<std::size_t> front_of(const Experiment& experiment, const std::string& workload);

/// Those of the front that are as fast as its fastest: their quartiles overlap.
std::vector<std::size_t> fastest_of_front(const Experiment& experiment, const std::string& workload);

/// "Moeller-Trumbore, float, 16 rays": with the number type where the method was measured in several, and with the knob
/// where there is one.
std::string name_of(const Experiment& experiment, const Measurement& row);

/// The unit of the errors: what stands in brackets behind the axis's name, or nothing. A share of wrong answers has
/// none.
std::string error_unit(const Experiment& experiment);

/// The axis's name without its unit.
std::string error_name(const Experiment& experiment);

/// An error as people write it: a share of wrong answers as share_text(), all others as number_text().
std::string error_text(const Experiment& experiment, double error);

/// The same of a measurement: where no error was seen, with its 95 % bound, "0 (< 15 ppm)".
std::string error_text(const Experiment& experiment, const Measurement& row);

}  // namespace raylab
