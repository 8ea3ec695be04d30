#include "raylab/report/chart/tradeoff_panels.h"

#include "raylab/report/experiment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace raylab {

namespace {

// Number types by rising precision; any other comes after them.
constexpr std::array known_numbers = {"float", "double", "long double"};

std::size_t rank_of(const std::string& number) {
    return static_cast<std::size_t>(std::ranges::find(known_numbers, number) - known_numbers.begin());
}

std::vector<std::string> numbers_of(const Experiment& experiment) {
    std::vector<std::string> numbers;
    for (const auto& row : experiment.rows)
        if (std::ranges::find(numbers, row.number) == numbers.end()) numbers.push_back(row.number);
    std::ranges::stable_sort(numbers, {}, rank_of);
    return numbers;
}

bool can_be_drawn(const Measurement& row) {
    return std::isfinite(row.error) && row.error >= 0 && std::isfinite(row.nanoseconds.median) &&
           row.nanoseconds.median > 0;
}

// Where no error was seen and no bound is known, the point is drawn a decade below the smallest error of all.
double below_all(const Experiment& experiment) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& row : experiment.rows) {
        if (!can_be_drawn(row)) continue;
        if (row.error > 0) smallest = std::min(smallest, row.error);
        if (row.error_bound > 0) smallest = std::min(smallest, row.error_bound);
    }
    return std::isfinite(smallest) ? smallest / 10 : 1;
}

// The shortest name that identifies a point: the knob alone where a legend shows its method and a knob was varied.
std::string label_of(const Experiment& experiment, const Measurement& row) {
    if (!row.knob.empty() && workloads_of(experiment).size() > 1) return row.knob;
    return name_of(experiment, row);
}

Dot dot_of(const Experiment& experiment, std::size_t index, const std::vector<std::string>& numbers, double zero) {
    const auto& row = experiment.rows[index];
    const bool seen = row.error > 0;
    const auto rank = static_cast<double>(std::ranges::find(numbers, row.number) - numbers.begin());
    return {.row = index,
            .name = label_of(experiment, row),
            .error = seen                  ? row.error
                     : row.error_bound > 0 ? row.error_bound
                                           : zero,
            .time = row.nanoseconds.median,
            .error_low = row.error_interval ? row.error_interval->low : row.error,
            .error_high = row.error_interval ? row.error_interval->high : row.error,
            .time_low = row.nanoseconds.low,
            .time_high = row.nanoseconds.high,
            .look = style_of(experiment, row.method),
            .size = 1 + 0.35 * rank,
            .kind = seen ? Dot::Kind::error_seen : Dot::Kind::no_error_seen,
            .place = Dot::Place::behind};
}

// A method's points in the order in which they were measured; by number type where several were measured.
std::vector<std::vector<std::size_t>> curves_of(const Experiment& experiment, const std::vector<Dot>& dots) {
    std::vector<std::size_t> order(dots.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return dots[i].row; });
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> curves;
    for (const auto i : order) {
        const auto& row = experiment.rows[dots[i].row];
        curves[{row.method, row.knob.empty() ? "" : row.number}].push_back(i);
    }
    std::vector<std::vector<std::size_t>> lines;
    for (auto& [name, indices] : curves)
        if (indices.size() > 1) lines.push_back(std::move(indices));
    return lines;
}

TradeoffPanel panel_of(const Experiment& experiment, const std::string& workload,
                       const std::vector<std::string>& numbers, double zero) {
    TradeoffPanel panel{workload, {}, {}};
    const auto front = front_of(experiment, workload);
    for (const auto i : front)
        if (can_be_drawn(experiment.rows[i])) panel.dots.push_back(dot_of(experiment, i, numbers, zero));
    for (auto& dot : panel.dots) dot.place = Dot::Place::front;
    for (const auto i : rows_of(experiment, workload))
        if (can_be_drawn(experiment.rows[i]) && std::ranges::find(front, i) == front.end())
            panel.dots.push_back(dot_of(experiment, i, numbers, zero));
    panel.curves = curves_of(experiment, panel.dots);
    return panel;
}

}  // namespace

MarkerStyle style_of(const Experiment& experiment, const std::string& method) {
    if (method == "yours") return style_of_yours();
    auto methods = methods_of(experiment);
    std::erase(methods, "yours");  // so that the other methods look the same with it and without it
    return style_of(static_cast<std::size_t>(std::ranges::find(methods, method) - methods.begin()));
}

Tradeoffs tradeoffs_of(const Experiment& experiment) {
    Tradeoffs tradeoffs;
    tradeoffs.numbers = numbers_of(experiment);
    const double zero = below_all(experiment);
    std::vector<double> errors, times;
    for (const auto& workload : workloads_of(experiment)) {
        tradeoffs.panels.push_back(panel_of(experiment, workload, tradeoffs.numbers, zero));
        for (const auto& dot : tradeoffs.panels.back().dots) {
            errors.push_back(dot.error);
            if (dot.error_low > 0) errors.insert(errors.end(), {dot.error_low, dot.error_high});
            times.insert(times.end(), {dot.time, dot.time_low, dot.time_high});
        }
    }
    for (const auto& row : experiment.rows)
        if (!can_be_drawn(row)) tradeoffs.left_out.push_back(row.method + ", " + row.number + " on " + row.workload);
    tradeoffs.error = broken_axis_for(errors, 0.1);
    tradeoffs.time = broken_axis_for(times, 0.1);
    return tradeoffs;
}

}  // namespace raylab
