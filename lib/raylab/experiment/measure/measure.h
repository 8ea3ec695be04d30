#pragma once

#include "raylab/experiment/measure/method.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Measures speed against accuracy: for each method and workload the error against the truth, the time, and counts.

namespace raylab {

/// A median with its spread (quartiles).
struct Spread {
    double median = 0, low = 0, high = 0;
};

Spread spread_of(std::vector<double> values);

/// Whether the quartiles overlap: the measurement does not tell which of the two is less.
inline bool tied(const Spread& a, const Spread& b) { return a.low <= b.high && b.low <= a.high; }

/// One method on one workload.
struct Measurement {
    std::string method;    // Method::name
    std::string number;    // Method::number
    std::string workload;  // "edge-aimed"
    // The setting of a method that is measured with several: "16 rays"; these points form one curve.
    std::string knob = {};
    std::string source = {};  // Method::source
    double error = 0;         // in the experiment's error unit; 0 is drawn at its 95 % bound
    double error_bound = 0;   // 3/N for a share of N decisions (rule of three); 0: none
    // The 95 % confidence interval of an error that is itself an estimate; absent: it is none.
    struct ErrorInterval {
        double low, high;
    };
    std::optional<ErrorInterval> error_interval = {};
    Spread nanoseconds = {};          // per query, median and quartiles over the repetitions
    Spread prepare_nanoseconds = {};  // the whole preparation
    std::size_t queries = 0;
    // Counts that do not depend on the machine: "miss ppm", "false hit ppm", ...
    std::map<std::string, double> counts = {};
};

/// A question's measurements: the rows of a table, the points of a chart.
struct Experiment {
    std::string question;    // "ray_triangle"
    std::string title;       // "Does a ray hit a triangle?"
    std::string error_axis;  // "wrong decisions [ppm]"
    std::vector<Measurement> rows;
    // What these rows answer, in one sentence. Where it is empty, answer_of() finds the sentence.
    std::function<std::string(const Experiment&)> answer = {};
};

/// A judge's result for one method's answers to one workload.
struct Judgement {
    double error = 0;
    double error_bound = 0;
    std::map<std::string, double> counts = {};
};

struct MeasureOptions {
    int repeats = 7;
    // The minimum duration of a timed batch in seconds: queries are repeated until it is reached.
    double shortest = 0.002;
    enum class Clock {
        wall,    // the time that a user waits
        thread,  // the processor time of this thread, which is the same on a busy machine; for work of one thread
    } clock = Clock::wall;

    MeasureOptions with(Clock other) const { return {.repeats = repeats, .shortest = shortest, .clock = other}; }
};

/// Measures the time of `run` (one pass over `queries` queries): one warm-up, then repetitions. The result is in
/// nanoseconds per query.
Spread time_per_query(std::size_t queries, const std::function<void()>& run, const MeasureOptions& options = {});

/// Runs one method on one workload and lets `judge`, a Judgement(std::span<const Result>), compare its answers with the
/// truth. Answers are given in this thread, so their time is its processor time.
template <class Data, class Query, class Result, std::invocable<std::span<const Result>> Judge>
Measurement measure(const Method<Data, Query, Result>& method, const Workload<Data, Query>& workload,
                    const Judge& judge, const MeasureOptions& options = {}) {
    Measurement row{.method = method.name,
                    .number = method.number,
                    .workload = workload.name,
                    .source = method.source,
                    .queries = workload.queries.size()};
    std::any state;
    if (method.prepare)
        row.prepare_nanoseconds = time_per_query(
            1, [&] { state = method.prepare(workload.data); }, options);
    std::vector<Result> results(workload.queries.size());
    const auto answer = [&] { method.answer(state, workload.data, workload.queries, results); };
    row.nanoseconds = time_per_query(workload.queries.size(), answer, options.with(MeasureOptions::Clock::thread));
    const Judgement verdict = judge(results);
    row.error = verdict.error;
    row.error_bound = verdict.error_bound;
    row.counts = verdict.counts;
    return row;
}

}  // namespace raylab
