#include "raylab/report/chart/decision_layout.h"

#include "raylab/report/experiment.h"

#include <algorithm>

namespace raylab {

DecisionLayout::DecisionLayout(const Experiment& experiment, const std::vector<MethodRows>& methods) {
    double longest = bold_label_width(methods.front().name, name_text.size);
    for (const auto& method : methods) longest = std::max(longest, label_width(method.name, name_text.size));
    const auto workloads = workloads_of(experiment);
    const bool many = workloads.size() > 7;
    table = margin + longest + 12;
    column = many ? 62 : 78;
    strip = table + column * static_cast<double>(workloads.size()) + 26;
    strip_width = many ? 290 : 400;
    width = strip + strip_width + margin;
    words = ChartWords(experiment, width - 2 * margin);
    std::size_t lines = 1;
    for (const auto& workload : workloads) {
        headers.push_back(lines_in(workload, column - bracket - 2, small_text));
        lines = std::max(lines, headers.back().size());
    }
    top = words.height() + 30 + 15 * static_cast<double>(lines);
    bottom = top + row_height * static_cast<double>(methods.size());
}

Rectangle DecisionLayout::cell(std::size_t method, std::size_t workload) const {
    const double x = table + column * static_cast<double>(workload);
    return {x + 1, row(method) - row_height / 2 + 1, x + column - bracket, row(method) + row_height / 2 - 1};
}

}  // namespace raylab
