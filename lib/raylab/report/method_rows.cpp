#include "raylab/report/method_rows.h"

#include "raylab/report/experiment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace raylab {

namespace {

/// The least median time of each workload.
std::vector<double> least_times(const Experiment& experiment) {
    std::vector<double> times;
    for (const auto& workload : workloads_of(experiment)) {
        times.push_back(std::numeric_limits<double>::infinity());
        for (const auto i : rows_of(experiment, workload))
            if (experiment.rows[i].nanoseconds.median > 0)
                times.back() = std::min(times.back(), experiment.rows[i].nanoseconds.median);
    }
    return times;
}

std::vector<MethodRows> methods_as_measured(const Experiment& experiment) {
    const auto workloads = workloads_of(experiment);
    std::vector<MethodRows> methods;
    for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
        const auto& row = experiment.rows[i];
        const auto name = name_of(experiment, row);
        auto method = std::ranges::find(methods, name, &MethodRows::name);
        if (method == methods.end())
            method = methods.insert(
                method, {name, row.method, std::vector<std::optional<std::size_t>>(workloads.size()), 0, 1});
        const auto workload = std::ranges::find(workloads, row.workload) - workloads.begin();
        method->rows[static_cast<std::size_t>(workload)] = i;
    }
    return methods;
}

}  // namespace

bool MethodRows::everywhere() const {
    return std::ranges::all_of(rows, [](const auto& row) { return row.has_value(); });
}

std::vector<MethodRows> methods_in_order(const Experiment& experiment) {
    const auto least = least_times(experiment);
    auto methods = methods_as_measured(experiment);
    for (auto& method : methods) {
        double logarithms = 0, count = 0;
        for (std::size_t w = 0; w < least.size(); ++w) {
            if (!method.rows[w]) continue;
            const auto& row = experiment.rows[*method.rows[w]];
            method.worst_error = std::isnan(row.error) ? row.error : std::max(method.worst_error, row.error);
            if (!(row.nanoseconds.median > 0)) continue;
            logarithms += std::log(row.nanoseconds.median / least[w]);
            ++count;
        }
        if (count > 0) method.slowness = std::exp(logarithms / count);
    }
    // An error that is not a number stands last.
    std::ranges::stable_sort(methods, {}, [](const MethodRows& method) {
        return std::tuple(std::isnan(method.worst_error), std::isnan(method.worst_error) ? 0 : method.worst_error,
                          method.slowness);
    });
    return methods;
}

}  // namespace raylab
