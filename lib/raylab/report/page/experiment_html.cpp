#include "raylab/report/experiment.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"
#include "raylab/report/table.h"

#include <algorithm>
#include <optional>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// A description of the chart for those who cannot see it.
std::string alternative_text(const Experiment& experiment) {
    std::string text =
        "Chart: " + experiment.title + " Across: " + experiment.error_axis + ", up: nanoseconds a query.";
    for (const auto& workload : workloads_of(experiment)) {
        text += " On the Pareto front of " + workload + ":";
        for (const auto i : front_of(experiment, workload)) {
            const auto& row = experiment.rows[i];
            text += " " + name_of(experiment, row) + " (error " + error_text(experiment, row) + ", " +
                    number_text(row.nanoseconds.median) + " ns);";
        }
    }
    return text;
}

std::string chart_html(const fs::path& folder, const Experiment& experiment, const std::string& name) {
    std::string files;
    for (const auto* extension : {".svg", ".png", ".csv", ".json", ".gp"})
        if (fs::exists(folder / (name + extension)))
            files += " <a href=\"" + escape_html(name + extension) + "\">" + extension + "</a>";
    if (!fs::exists(folder / (name + ".svg")))
        return "<p>No chart: gnuplot was not found on this machine. The data:" + files + "</p>\n";
    const bool without_error = std::ranges::find(experiment.rows, 0.0, &Measurement::error) != experiment.rows.end();
    return "<figure class=\"chart wide\">" + picture_html(folder, name + ".svg", alternative_text(experiment)) +
           "<figcaption>Error against the exact truth across, time up: the lower left is better. The grey steps are "
           "the Pareto front: no other method is both faster and more accurate. " +
           (without_error ? "Hollow marks with an arrow saw no error; they stand at the 95 % bound 3/N. " : "") +
           "Bars: quartiles of the repeats. As" + files + "</figcaption></figure>\n";
}

std::optional<Measurement> find_row(const Experiment& experiment, const std::string& title,
                                    const std::string& workload) {
    for (const auto& row : experiment.rows)
        if (name_of(experiment, row) == title && row.workload == workload) return row;
    return std::nullopt;
}

// A table with methods as rows and workloads as columns: the errors, and the range of the median times over the
// workloads.
std::string glance_html(const Experiment& experiment) {
    const auto workloads = workloads_of(experiment);
    std::vector<std::string> titles;
    for (const auto& row : experiment.rows)
        if (std::ranges::find(titles, name_of(experiment, row)) == titles.end())
            titles.push_back(name_of(experiment, row));
    std::vector<std::string> header = {"method"};
    header.insert(header.end(), workloads.begin(), workloads.end());
    header.push_back("ns a query");
    std::vector<std::vector<std::string>> rows;
    for (const auto& title : titles) {
        std::vector<std::string> cells = {title};
        std::vector<double> times;
        for (const auto& workload : workloads) {
            const auto row = find_row(experiment, title, workload);
            cells.push_back(row ? error_text(experiment, row->error) : "–");
            if (row) times.push_back(row->nanoseconds.median);
        }
        const auto [fastest, slowest] = std::ranges::minmax(times);
        cells.push_back(fastest == slowest ? number_text(fastest)
                                           : number_text(fastest) + " to " + number_text(slowest));
        rows.push_back(cells);
    }
    return table_html(header, rows, "At a glance: " + experiment.error_axis + " on each workload.");
}

std::string all_numbers_html(const Experiment& experiment) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : experiment.rows) {
        std::string counts;
        for (const auto& [name, value] : row.counts)
            counts += (counts.empty() ? "" : ", ") + name + " " + number_text(value);
        const auto& time = row.nanoseconds;
        const bool prepared = row.prepare_nanoseconds.median > 0;
        rows.push_back({row.workload, name_of(experiment, row), error_text(experiment, row), number_text(time.median),
                        number_text(time.low) + " to " + number_text(time.high),
                        prepared ? duration_text(row.prepare_nanoseconds.median) : "–", std::to_string(row.queries),
                        counts});
    }
    return "<details class=\"wide\"><summary>All " + std::to_string(rows.size()) + " measurements</summary>\n" +
           table_html({"workload", "method", experiment.error_axis, "ns a query", "quartiles", "preparation", "queries",
                       "counts"},
                      rows, "") +
           "</details>\n";
}

}  // namespace

std::string experiment_html(const fs::path& folder, const Experiment& experiment, const std::string& chart_name) {
    return chart_html(folder, experiment, chart_name) + glance_html(experiment) + all_numbers_html(experiment);
}

}  // namespace raylab
