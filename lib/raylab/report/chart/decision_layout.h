#pragma once

#include "raylab/report/chart/chart_words.h"
#include "raylab/report/method_rows.h"

#include <string>
#include <vector>

namespace raylab {

/// The places of all parts of a decision chart: names, a table of cells, and the strip of times beside it.
struct DecisionLayout {
    static constexpr double row_height = 26, margin = 16, bracket = 8;
    static inline const SketchText name_text{.size = 13}, small_text{.size = 13};

    DecisionLayout(const Experiment& experiment, const std::vector<MethodRows>& methods);

    /// The middle of a method's row.
    double row(std::size_t method) const { return top + row_height * (static_cast<double>(method) + 0.5); }
    Rectangle cell(std::size_t method, std::size_t workload) const;

    double table, column, strip, strip_width, width, top, bottom;  // left ends, and widths; of the rows: top, bottom
    ChartWords words;
    std::vector<std::vector<std::string>> headers;  // of each workload, in lines
};

}  // namespace raylab
