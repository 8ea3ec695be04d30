#include "raylab/report/experiment_text.h"

#include "raylab/report/experiment.h"
#include "raylab/report/finding.h"
#include "raylab/report/method_rows.h"
#include "raylab/report/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr std::size_t most_methods = 17;  // with the lines around them 25

std::string heading_of(const Experiment& experiment) {
    std::string text;
    for (const auto& line : wrapped(answer_of(experiment), terminal_width)) text += line + "\n";
    return text + experiment.title + "\n\n";
}

std::string error_heading(const Experiment& experiment) {
    const auto unit = errors_are_shares(experiment) ? "" : error_unit(experiment);
    return error_name(experiment) + (unit.empty() ? "" : " [" + unit + "]");
}

/// "12.3 to 45": the medians of all workloads.
std::string range_of_times(const Experiment& experiment, const MethodRows& method) {
    std::vector<double> times;
    for (const auto i : method.rows)
        if (i) times.push_back(experiment.rows[*i].nanoseconds.median);
    const auto [fastest, slowest] = std::ranges::minmax(times);
    return number_text(fastest) + (fastest == slowest ? "" : " to " + number_text(slowest));
}

std::vector<std::string> summary_of(const Experiment& experiment, const MethodRows& method) {
    const Measurement* worst = nullptr;
    std::size_t workloads = 0, fronts = 0;
    for (const auto i : method.rows) {
        if (!i) continue;
        const auto& row = experiment.rows[*i];
        if (worst == nullptr || row.error > worst->error) worst = &row;
        ++workloads;
        fronts += static_cast<std::size_t>(std::ranges::count(front_of(experiment, row.workload), *i));
    }
    return {method.name, error_text(experiment, *worst), worst->error > 0 ? worst->workload : "",
            range_of_times(experiment, method), fronts > 0 ? fmt::format("{} of {}", fronts, workloads) : ""};
}

}  // namespace

std::string summary_text(const Experiment& experiment) {
    const auto methods = methods_in_order(experiment);
    std::vector<std::vector<std::string>> rows;
    for (const auto& method : methods)
        if (rows.size() < most_methods) rows.push_back(summary_of(experiment, method));
    const auto more = methods.size() - rows.size();
    return heading_of(experiment) +
           text_table({"method", error_heading(experiment) + ", at most", "on", "ns a query", "on the front"}, rows) +
           (more > 0 ? fmt::format("  and {} more, which err more\n", more) : "");
}

std::string rows_text(const Experiment& experiment) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& workload : workloads_of(experiment)) {
        const auto front = front_of(experiment, workload);
        for (const auto i : rows_of(experiment, workload)) {
            const auto& row = experiment.rows[i];
            const bool on_front = std::ranges::find(front, i) != front.end();
            rows.push_back({row.workload, name_of(experiment, row), error_text(experiment, row),
                            number_text(row.nanoseconds.median), on_front ? "on the front" : ""});
        }
    }
    return heading_of(experiment) +
           text_table({"workload", "method", error_heading(experiment), "ns a query", ""}, rows);
}

}  // namespace raylab
