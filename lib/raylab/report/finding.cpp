#include "raylab/report/finding.h"

#include "raylab/base/number_text.h"
#include "raylab/report/experiment.h"
#include "raylab/report/method_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab {

namespace {

/// The time of a method on a workload beside the fastest one's.
struct Cost {
    std::string workload;
    double ratio;  // 1: a tie, or the fastest itself
    double fastest_error;
};

std::vector<Cost> costs_of(const Experiment& experiment, const MethodRows& method) {
    std::vector<Cost> costs;
    for (const auto i : method.rows) {
        const auto& row = experiment.rows[*i];
        const auto median_of = [&](std::size_t j) { return experiment.rows[j].nanoseconds.median; };
        const auto& fastest = experiment.rows[std::ranges::min(rows_of(experiment, row.workload), {}, median_of)];
        const bool tie = tied(row.nanoseconds, fastest.nanoseconds);
        costs.push_back({row.workload, tie ? 1 : row.nanoseconds.median / fastest.nanoseconds.median, fastest.error});
    }
    return costs;
}

/// "generic", "generic and edge", "3 of 5 workloads": where it is as fast as any.
std::string places_of(const std::vector<Cost>& costs) {
    std::vector<std::string> ties;
    for (const auto& cost : costs)
        if (cost.ratio == 1) ties.push_back(cost.workload);
    if (ties.size() > 2) return fmt::format("{} of {} workloads", ties.size(), costs.size());
    return ties.size() == 2 ? ties[0] + " and " + ties[1] : ties[0];
}

std::string cost_in_words(const Experiment& experiment, const MethodRows& method) {
    const auto costs = costs_of(experiment, method);
    const auto least = std::ranges::min(costs, {}, &Cost::ratio), most = std::ranges::max(costs, {}, &Cost::ratio);
    if (most.ratio == 1) return "as fast as any";
    const bool fastest_is_wrong = errors_are_shares(experiment) && most.fastest_error > 0;
    const auto there =
        fastest_is_wrong ? " (the fastest: " + error_text(experiment, most.fastest_error) + " wrong)" : std::string();
    if (costs.size() == 1) return ratio_text(most.ratio) + " the fastest's time" + there;
    if (least.ratio == 1)
        return "as fast as any on " + places_of(costs) + ", " + ratio_text(most.ratio) + " the fastest's time on " +
               most.workload + there;
    return ratio_text(least.ratio) + " the fastest's time on " + least.workload + ", " + ratio_text(most.ratio) +
           " on " + most.workload + there;
}

/// Of the methods that were measured everywhere and err hardly more than the best of them: the fastest.
const MethodRows* best_of(const std::vector<MethodRows>& methods) {
    constexpr double hardly_more = 1.1;
    const MethodRows* best = nullptr;
    double least_error = 0;
    for (const auto& method : methods) {
        if (!method.everywhere()) continue;
        if (best == nullptr) least_error = method.worst_error;
        const bool good = method.worst_error <= hardly_more * least_error;
        if (best == nullptr || (good && method.slowness < best->slowness)) best = &method;
    }
    return best;
}

/// The cheapest settings of a method that keep its error below a bound.
struct Within {
    std::string method, least, most;  // the settings with the least and the most time of all workloads
    double time;                      // the geometric mean over the workloads
};

std::optional<Within> within(const Experiment& experiment, const std::string& method, double bound) {
    std::vector<const Measurement*> cheapest;
    const auto workloads = workloads_of(experiment);
    double logarithms = 0;
    for (const auto& workload : workloads) {
        const Measurement* found = nullptr;
        for (const auto i : rows_of(experiment, workload)) {
            const auto& row = experiment.rows[i];
            const bool good = row.method == method && row.error < bound;
            if (good && (found == nullptr || row.nanoseconds.median < found->nanoseconds.median)) found = &row;
        }
        if (found == nullptr) return std::nullopt;
        cheapest.push_back(found);
        logarithms += std::log(found->nanoseconds.median);
    }
    std::ranges::stable_sort(cheapest, {}, [](const Measurement* row) { return row->nanoseconds.median; });
    return Within{method, cheapest.front()->knob, cheapest.back()->knob,
                  std::exp(logarithms / static_cast<double>(workloads.size()))};
}

// "1280 to 8192 triangles", "depth 3 to 7": what both say is said once.
std::string range_text(const std::string& least, const std::string& most) {
    if (least == most) return least;
    const auto first = least.find(' '), last = least.rfind(' ');
    if (first == std::string::npos) return least + " to " + most;
    if (most.ends_with(least.substr(last))) return least.substr(0, last) + " to " + most;
    const bool same_beginning = most.starts_with(least.substr(0, first + 1));
    return least + " to " + (same_beginning ? most.substr(first + 1) : most);
}

std::string found_answer(const Experiment& experiment) {
    const auto methods = methods_in_order(experiment);
    const auto* best = best_of(methods);
    if (best == nullptr) return fmt::format("{} methods, none of them measured everywhere", methods.size());
    std::size_t queries = 0;
    for (const auto i : best->rows) queries += experiment.rows[*i].queries;
    const auto count = count_text(queries) + " queries";
    const auto cost = cost_in_words(experiment, *best), worst = error_text(experiment, best->worst_error);
    if (!errors_are_shares(experiment)) {
        const auto unit = error_unit(experiment);
        return best->name + " errs least, at most " + worst + (unit.empty() ? "" : " " + unit) + ": " + cost;
    }
    if (best->worst_error == 0) return best->name + ": no " + error_name(experiment) + " in " + count + ", " + cost;
    return best->name + ": fewest " + error_name(experiment) + ", at most " + worst + ", " + cost;
}

}  // namespace

std::function<std::string(const Experiment&)> answer_within(double bound) {
    return [bound](const Experiment& experiment) {
        std::vector<Within> reached;
        std::string not_reached;
        for (const auto& method : methods_of(experiment)) {
            if (auto found = within(experiment, method, bound))
                reached.push_back(std::move(*found));
            else
                not_reached += (not_reached.empty() ? "; " : " and ") + method;
        }
        std::ranges::sort(reached, {}, &Within::time);
        std::string answer = "An error below " + number_text(bound) + " takes ";
        for (const auto& [method, least, most, time] : reached)
            answer +=
                (&method == &reached.front().method ? "" : ", ") + range_text(least, most) + " by " + method +
                (time > reached.front().time ? " (" + ratio_text(time / reached.front().time) + " the time)" : "");
        if (reached.empty()) answer += "more than was tried";
        return answer + (not_reached.empty() ? "" : not_reached + " does not reach it everywhere");
    };
}

std::string answer_of(const Experiment& experiment) {
    return experiment.answer ? experiment.answer(experiment) : found_answer(experiment);
}

}  // namespace raylab
