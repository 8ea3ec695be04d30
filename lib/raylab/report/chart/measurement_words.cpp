#include "raylab/report/chart/measurement_words.h"

#include "raylab/base/number_text.h"
#include "raylab/report/experiment.h"

#include <fmt/format.h>

namespace raylab {

MarkWords measurement_words(const Experiment& experiment, const Measurement& row) {
    const auto& time = row.nanoseconds;
    const auto unit = errors_are_shares(experiment) ? "" : error_unit(experiment);
    MarkWords words;
    words.tooltip =
        fmt::format("{}, {}{}\n{}\n{}: {}{}\n{} ns a query (quartiles {} to {})\n{} queries", row.method, row.number,
                    row.knob.empty() ? "" : ", " + row.knob, row.workload, error_name(experiment),
                    error_text(experiment, row), unit.empty() ? "" : " " + unit, number_text(time.median),
                    number_text(time.low), number_text(time.high), count_text(row.queries));
    if (!row.source.empty()) words.tooltip += "\n" + row.source;
    words.data = {{"method", row.method},
                  {"number", row.number},
                  {"knob", row.knob},
                  {"workload", row.workload},
                  {"error", fmt::format("{:.6g}", row.error)},
                  {"nanoseconds", fmt::format("{:.6g}", time.median)},
                  {"queries", std::to_string(row.queries)},
                  {"source", row.source}};
    return words;
}

}  // namespace raylab
