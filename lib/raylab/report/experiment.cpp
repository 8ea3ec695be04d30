#include "raylab/report/experiment.h"

#include "raylab/report/chart/pareto.h"
#include "raylab/report/finding.h"
#include "raylab/report/table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace raylab {

namespace {

// The shortest text that reads back as the same double.
std::string exact_text(double value) { return fmt::format("{}", value); }

std::vector<std::string> in_order(const Experiment& experiment, std::string Measurement::*name) {
    std::vector<std::string> names;
    for (const auto& row : experiment.rows)
        if (std::ranges::find(names, row.*name) == names.end()) names.push_back(row.*name);
    return names;
}

// Whether each row is on the front of its workload.
std::vector<bool> on_front(const Experiment& experiment) {
    std::vector<bool> marks(experiment.rows.size(), false);
    for (const auto& workload : workloads_of(experiment))
        for (const auto i : front_of(experiment, workload)) marks[i] = true;
    return marks;
}

nlohmann::ordered_json to_json(const Spread& spread) {
    return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

}  // namespace

std::vector<std::string> workloads_of(const Experiment& experiment) {
    return in_order(experiment, &Measurement::workload);
}

std::vector<std::string> methods_of(const Experiment& experiment) { return in_order(experiment, &Measurement::method); }

std::vector<std::size_t> rows_of(const Experiment& experiment, const std::string& workload) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < experiment.rows.size(); ++i)
        if (experiment.rows[i].workload == workload) indices.push_back(i);
    return indices;
}

bool errors_are_shares(const Experiment& experiment) { return error_unit(experiment) == "ppm"; }

std::vector<std::size_t> front_of(const Experiment& experiment, const std::string& workload) {
    auto indices = rows_of(experiment, workload);
    if (errors_are_shares(experiment))
        std::erase_if(indices, [&](std::size_t i) { return experiment.rows[i].error > most_wrong_on_front; });
    std::vector<Tradeoff> points;
    for (const auto i : indices) points.push_back({experiment.rows[i].error, experiment.rows[i].nanoseconds});
    auto front = pareto_front(points);
    for (auto& i : front) i = indices[i];
    return front;
}

std::vector<std::size_t> fastest_of_front(const Experiment& experiment, const std::string& workload) {
    const auto time_of = [&](std::size_t i) { return experiment.rows[i].nanoseconds; };
    auto front = front_of(experiment, workload);
    if (front.empty()) return front;
    const auto fastest = *std::ranges::min_element(front, {}, [&](std::size_t i) { return time_of(i).median; });
    std::erase_if(front, [&](std::size_t i) { return !tied(time_of(i), time_of(fastest)); });
    return front;
}

std::string name_of(const Experiment& experiment, const Measurement& row) {
    const bool one_number = std::ranges::all_of(experiment.rows, [&](const Measurement& other) {
        return other.method != row.method || other.number == row.number;
    });
    return row.method + (one_number ? "" : ", " + row.number) + (row.knob.empty() ? "" : ", " + row.knob);
}

std::string error_name(const Experiment& experiment) {
    return experiment.error_axis.substr(0, experiment.error_axis.find(" ["));
}

std::string error_unit(const Experiment& experiment) {
    const auto& axis = experiment.error_axis;
    const auto bracket = axis.find('[');
    return bracket == std::string::npos ? "" : axis.substr(bracket + 1, axis.find(']') - bracket - 1);
}

std::string error_text(const Experiment& experiment, double error) {
    return errors_are_shares(experiment) ? share_text(error / 1e6) : number_text(error);
}

std::string error_text(const Experiment& experiment, const Measurement& row) {
    if (row.error > 0 || row.error_bound == 0) return error_text(experiment, row.error);
    return "0 (< " + error_text(experiment, row.error_bound) + ")";
}

std::string to_csv(const Experiment& experiment) {
    std::set<std::string> counts;
    for (const auto& row : experiment.rows)
        for (const auto& [name, value] : row.counts) counts.insert(name);
    std::vector<std::string> header = {"method",     "number",    "knob",   "workload", experiment.error_axis,
                                       "95 % bound", "ns median", "ns low", "ns high",  "prepare ns median",
                                       "queries",    "on front"};
    header.insert(header.end(), counts.begin(), counts.end());
    std::string text = csv_record(header);
    const auto front = on_front(experiment);
    for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
        const auto& row = experiment.rows[i];
        std::vector<std::string> cells = {row.method,
                                          row.number,
                                          row.knob,
                                          row.workload,
                                          exact_text(row.error),
                                          exact_text(row.error_bound),
                                          exact_text(row.nanoseconds.median),
                                          exact_text(row.nanoseconds.low),
                                          exact_text(row.nanoseconds.high),
                                          exact_text(row.prepare_nanoseconds.median),
                                          std::to_string(row.queries),
                                          front[i] ? "yes" : "no"};
        for (const auto& name : counts)
            cells.push_back(row.counts.contains(name) ? exact_text(row.counts.at(name)) : "");
        text += csv_record(cells);
    }
    return text;
}

nlohmann::ordered_json to_json(const Experiment& experiment) {
    auto rows = nlohmann::ordered_json::array();
    const auto front = on_front(experiment);
    for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
        const auto& row = experiment.rows[i];
        rows.push_back({{"method", row.method},
                        {"number", row.number},
                        {"knob", row.knob},
                        {"workload", row.workload},
                        {"source", row.source},
                        {"error", row.error},
                        {"error_bound", row.error_bound},
                        {"error_interval",
                         row.error_interval ? nlohmann::ordered_json{row.error_interval->low, row.error_interval->high}
                                            : nlohmann::ordered_json()},
                        {"nanoseconds", to_json(row.nanoseconds)},
                        {"prepare_nanoseconds", to_json(row.prepare_nanoseconds)},
                        {"queries", row.queries},
                        {"on_front", bool(front[i])},
                        {"counts", row.counts}});
    }
    return {{"question", experiment.question},
            {"title", experiment.title},
            {"answer", answer_of(experiment)},
            {"error_axis", experiment.error_axis},
            {"rows", rows}};
}

}  // namespace raylab
