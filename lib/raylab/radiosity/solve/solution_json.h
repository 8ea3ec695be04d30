#pragma once

#include "raylab/radiosity/solve/solver.h"
#include "raylab/radiosity/system/power_balance.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab {

/// What a command tells of a solution as JSON: {solver, iterations, residual, error_bound, converged, row_sums:
/// {least, largest, mean}, reciprocity_error, power: {emitted, absorbed, lost, imbalance}}. Powers are [r, g, b] in
/// watts, the errors are relative.
nlohmann::ordered_json solution_json(const RadiositySystem& system, const Solution& solution,
                                     const SolverOptions& options);

/// {emitted, absorbed, lost, imbalance}.
nlohmann::ordered_json power_json(const PowerBalance& power);

/// The radiosity of each patch, as [r, g, b].
nlohmann::ordered_json radiosities_json(const Radiosities& radiosity);

}  // namespace raylab
