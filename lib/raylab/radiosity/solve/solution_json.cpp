#include "raylab/radiosity/solve/solution_json.h"

#include "raylab/radiosity/system/reciprocity.h"
#include "raylab/radiosity/system/row_sums.h"

#include <nlohmann/json.hpp>

namespace raylab {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const Color& color) { return {color.r, color.g, color.b}; }

}  // namespace

ordered_json solution_json(const RadiositySystem& system, const Solution& solution, const SolverOptions& options) {
    const RowSums sums = row_sums(system.form_factors, options.threads);
    const PowerBalance power = power_balance(system, solution.radiosity, options.threads);
    return {{"solver", solution.solver},
            {"iterations", solution.iterations},
            {"residual", solution.residual},
            {"error_bound", solution.error_bound},
            {"converged", solution.residual <= options.residual},
            {"row_sums", {{"least", sums.least}, {"largest", sums.largest}, {"mean", sums.mean}}},
            {"reciprocity_error", reciprocity_error(system.form_factors, system.area).largest_relative},
            {"power", power_json(power)}};
}

ordered_json power_json(const PowerBalance& power) {
    return {{"emitted", to_json(power.emitted)},
            {"absorbed", to_json(power.absorbed)},
            {"lost", to_json(power.lost)},
            {"imbalance", power.imbalance}};
}

ordered_json radiosities_json(const Radiosities& radiosity) {
    ordered_json list = ordered_json::array();
    for (const Color& b : radiosity) list.push_back(to_json(b));
    return list;
}

}  // namespace raylab
