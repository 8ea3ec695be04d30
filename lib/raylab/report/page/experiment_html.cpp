#include "raylab/base/file.h"
#include "raylab/report/experiment.h"
#include "raylab/report/finding.h"
#include "raylab/report/method_rows.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/inline_svg.h"
#include "raylab/report/page/page_parts.h"
#include "raylab/report/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

/// A cell of a table that can be sorted: what it shows, and by what it is sorted.
struct Cell {
    std::string text;
    double sort;
};

std::string sortable_table(const std::vector<std::string>& header, const std::vector<std::string>& names,
                           const std::vector<std::vector<Cell>>& rows) {
    std::string html = "<div class=\"scroll wide\" tabindex=\"0\"><table>\n<thead><tr>";
    for (const auto& one : header) html += "<th scope=\"col\">" + escape_html(one) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        html += "<tr><th scope=\"row\">" + escape_html(names[i]) + "</th>";
        for (const auto& cell : rows[i])
            html += fmt::format("<td class=\"data\" data-sort=\"{:.9g}\">{}</td>", cell.sort, escape_html(cell.text));
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

/// Methods as rows and workloads as columns: the errors, and the range of the median times.
std::string methods_html(const Experiment& experiment) {
    auto header = workloads_of(experiment);
    header.insert(header.begin(), "method");
    header.insert(header.end(), {"ns, least", "ns, most"});
    std::vector<std::string> names;
    std::vector<std::vector<Cell>> rows;
    for (const auto& method : methods_in_order(experiment)) {
        names.push_back(method.name);
        rows.emplace_back();
        std::vector<double> times;
        for (const auto i : method.rows) {
            const auto* row = i ? &experiment.rows[*i] : nullptr;
            rows.back().push_back(row ? Cell{error_text(experiment, row->error), row->error} : Cell{"–", -1});
            if (row) times.push_back(row->nanoseconds.median);
        }
        for (const double time : {std::ranges::min(times), std::ranges::max(times)})
            rows.back().push_back({number_text(time), time});
    }
    return sortable_table(header, names, rows);
}

std::string measurements_html(const Experiment& experiment) {
    std::vector<std::string> names;
    std::vector<std::vector<Cell>> rows;
    const auto workloads = workloads_of(experiment);
    for (const auto& row : experiment.rows) {
        std::string counts;
        for (const auto& [name, value] : row.counts)
            counts += (counts.empty() ? "" : ", ") + name + " " + number_text(value);
        const auto& [median, low, high] = row.nanoseconds;
        const double prepared = row.prepare_nanoseconds.median;
        const auto workload = static_cast<double>(std::ranges::find(workloads, row.workload) - workloads.begin());
        names.push_back(name_of(experiment, row));
        rows.push_back({{row.workload, workload},
                        {error_text(experiment, row), row.error},
                        {number_text(median), median},
                        {number_text(low) + " to " + number_text(high), high - low},
                        {prepared > 0 ? duration_text(prepared) : "–", prepared},
                        {count_text(row.queries), static_cast<double>(row.queries)},
                        {counts, 0}});
    }
    return sortable_table(
        {"method", "workload", experiment.error_axis, "ns a query", "quartiles", "preparation", "queries", "counts"},
        names, rows);
}

std::string chart_html(const fs::path& folder, const Experiment& experiment, const std::string& name) {
    std::string files;
    for (const std::string extension : {".svg", ".png", ".csv", ".json"})
        files += " <a href=\"" + escape_html(name + extension) + "\">" + extension.substr(1) + "</a>";
    const auto answer = answer_of(experiment);
    return "<figure class=\"chart wide\" id=\"chart-" + escape_html(name) +
           "\">\n<div class=\"scroll\" tabindex=\"0\">" +
           inline_svg(read_file(folder / (name + ".svg")), name, "Chart: " + answer) + "</div>\n<figcaption>" +
           escape_html(experiment.title) + " The numbers are in the tables below, and in these files:" + files +
           "<span class=\"command\"><code>./raylab chart " + escape_html(name) +
           "</code></span></figcaption></figure>\n";
}

}  // namespace

std::string experiment_html(const fs::path& folder, const Experiment& experiment, const std::string& chart_name) {
    return chart_html(folder, experiment, chart_name) + "<details class=\"wide\"><summary>" +
           escape_html("The chart as a table: " + experiment.error_axis) + "</summary>\n" + methods_html(experiment) +
           "</details>\n<details class=\"wide\"><summary>All " + std::to_string(experiment.rows.size()) +
           " measurements</summary>\n" + measurements_html(experiment) + "</details>\n";
}

}  // namespace raylab
