#include "class_table.h"
#include "part_text.h"

#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::grading {

namespace {

// Bars of a share, in the book's colours.
constexpr const char* bar_style = R"(<style>
.bar { display: inline-block; height: 0.8em; background: var(--link); border-radius: 2px; vertical-align: middle; min-width: 1px; }
.bar.bad { background: var(--bad); }
.histogram { display: flex; align-items: flex-end; gap: 4px; height: 11rem; margin: 1.5rem 0 0.3rem; max-width: 42rem; border-bottom: 1px solid var(--rule); }
.histogram div { flex: 1; background: var(--link); border-radius: 3px 3px 0 0; position: relative; min-height: 1px; }
.histogram span { position: absolute; top: -1.3em; left: 0; right: 0; text-align: center; font-size: 0.75rem; font-family: system-ui, sans-serif; }
.ticks { display: flex; gap: 4px; max-width: 42rem; font-size: 0.75rem; color: var(--quiet); font-family: system-ui, sans-serif; }
.ticks span { flex: 1; text-align: center; }
</style>
)";

std::string text(const std::string& words) { return escape_html(safe_text(words, longest_message)); }

std::string cells(const std::vector<std::string>& row, const char* element) {
    std::string html = "<tr>";
    for (const auto& cell : row) html += fmt::format("<{0}>{1}</{0}>", element, cell);
    return html + "</tr>\n";
}

std::string table_of(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
    std::string html =
        "<div class=\"scroll wide\" tabindex=\"0\"><table>\n<thead>" + cells(header, "th") + "</thead>\n<tbody>\n";
    for (const auto& row : rows) html += cells(row, "td");
    return html + "</tbody></table></div>\n";
}

std::string histogram(const std::vector<std::size_t>& counts) {
    const double highest = static_cast<double>(std::max<std::size_t>(1, std::ranges::max(counts)));
    std::string bars, ticks;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto count = static_cast<double>(counts[i]);
        bars += fmt::format("<div style=\"height:{:.1f}%\"><span>{}</span></div>", 88 * count / highest,
                            counts[i] ? std::to_string(counts[i]) : "");
        ticks += i + 1 < counts.size() ? fmt::format("<span>{}&ndash;{}</span>", 10 * i, 10 * i + 9)
                                       : std::string("<span>100</span>");
    }
    return "<div class=\"histogram\">" + bars + "</div><div class=\"ticks\">" + ticks +
           "</div>\n<p>Submissions by per cent of the points.</p>\n";
}

std::string link_to(const ClassTable& table, const std::string& student) {
    const auto row = std::ranges::find(table.students, student, &StudentRow::student);
    return fmt::format("<a href=\"{}\">{}</a>", page_of(table, *row), text(student));
}

std::string links_to(const ClassTable& table, const std::vector<std::string>& students) {
    constexpr std::size_t shown = 12;
    std::string html;
    for (std::size_t i = 0; i < std::min(students.size(), shown); ++i)
        html += (i ? ", " : "") + link_to(table, students[i]);
    return students.size() > shown ? html + fmt::format(" and {} more", students.size() - shown) : html;
}

std::string parts_table(const AssignmentSummary& summary) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, failed, asked] : summary.parts) {
        const double share = asked ? static_cast<double>(failed) / static_cast<double>(asked) : 0;
        rows.push_back({text(name), fmt::format("{} of {}", failed, asked),
                        fmt::format("<span class=\"bar bad\" style=\"width:{:.1f}rem\"></span> {:.0f} %", 10 * share,
                                    100 * share)});
    }
    return table_of({"part", "fails for", ""}, rows);
}

std::string alike_table(const ClassTable& table, const AssignmentSummary& summary) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& group : summary.alike)
        rows.push_back({std::to_string(group.students.size()), to_string(group.outcome), text(group.shared),
                        links_to(table, group.students)});
    return table_of({"submissions", "verdict", "what they share", "of"}, rows);
}

std::string assignment_html(const ClassTable& table, const AssignmentSummary& summary) {
    const auto& [exercise, weight, deadline, late] = summary.assignment;
    std::string html = fmt::format("<h2>Exercise {}</h2>\n<p>{} submissions, {} pass, on average {:.0f} % of the "
                                   "points.{}{}</p>\n",
                                   text(exercise->folder), summary.graded, summary.passed, summary.mean,
                                   deadline ? fmt::format(" Deadline {}.", to_string(*deadline)) : "",
                                   weight == 1 ? "" : fmt::format(" Weight {}.", weight));
    if (summary.internal)
        html += fmt::format("<p><strong>{} could not be graded</strong>: the same command tries them again.</p>\n",
                            summary.internal);
    html += histogram(summary.distribution) + "<h3>Which cases fail most</h3>\n" + parts_table(summary);
    if (!summary.alike.empty()) html += "<h3>Wrong in the same way</h3>\n" + alike_table(table, summary);
    return html;
}

std::string points_cell(const Counted& counted) {
    if (!counted.grade) return "&ndash;";
    if (counted.grade->outcome == Outcome::internal) return "<strong>not graded</strong>";
    return fmt::format("{:.2f} <small>{}{}{}</small>", counted.points, to_string(counted.grade->outcome),
                       counted.late ? ", late" : "", counted.lost ? ", no longer in the class" : "");
}

std::string students_table(const ClassTable& table) {
    std::vector<std::string> header{"student", "total %"};
    for (const auto& summary : table.assignments) header.push_back(text(summary.assignment.exercise->folder));
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table.students) {
        rows.push_back({link_to(table, row.student), fmt::format("{:.1f}", row.total)});
        for (const auto& counted : row.results) rows.back().push_back(points_cell(counted));
    }
    return table_of(header, rows);
}

std::string block(const std::string& title, const std::string& words) {
    return words.empty() ? ""
                         : "<h3>" + title + "</h3>\n<pre>" + escape_html(safe_text(words, longest_output)) + "</pre>\n";
}

std::string grade_html(const Counted& counted) {
    const auto& grade = *counted.grade;
    std::vector<std::vector<std::string>> rows;
    for (const auto& part : grade.parts)
        rows.push_back({part.passed() ? "✓" : "✗", text(part.name), points_text(part.points), points_text(part.most),
                        text(part.message)});
    std::string html =
        fmt::format("<h2>Exercise {}</h2>\n<p>{}: {} of {} points{}. {}</p>\n", text(grade.exercise),
                    to_string(grade.outcome), points_text(grade.points()), points_text(grade.most),
                    counted.late ? fmt::format(", of which {:.2f} count, since it is late", counted.points) : "",
                    text(grade.summary));
    html += rows.empty() ? "" : table_of({"", "part", "points", "of", ""}, rows);
    if (const auto& wrong = grade.first_wrong)
        html +=
            block("The first wrong answer", fmt::format("case {}, {}\n{}\nexpected   {}\ngot        {}", wrong->index,
                                                        wrong->group, wrong->story, wrong->expected, wrong->got));
    if (!grade.hint.empty()) html += "<h3>What is probably wrong</h3>\n<p>" + text(grade.hint) + "</p>\n";
    html += block("The compiler", grade.compiler) + block("How it ended", grade.details) +
            block("It printed", grade.printed);
    return html + fmt::format("<p><small>{}; file {}, SHA-256 {}</small></p>\n", text(conditions_text(grade)),
                              text(grade.submitted.file), text(grade.submitted.sha256));
}

}  // namespace

std::string page_of(const ClassTable& table, const StudentRow& row) {
    return fmt::format("students/{:04}.html", &row - table.students.data() + 1);
}

std::string class_page(const ClassTable& table) {
    const auto title = table.title.empty() ? "The class" : table.title;
    std::string body = std::string(bar_style) + "<main id=\"content\">\n<h1>" + text(title) + "</h1>\n<p>" +
                       fmt::format("{} students; <a href=\"grades.csv\">grades.csv</a>, "
                                   "<a href=\"grades.json\">grades.json</a></p>\n",
                                   table.students.size());
    for (const auto& summary : table.assignments) body += assignment_html(table, summary);
    return whole_page({.title = title}, "", body + "<h2>Students</h2>\n" + students_table(table) + "</main>\n");
}

std::string student_page(const ClassTable& table, const StudentRow& row) {
    std::string body = "<style>pre { white-space: pre-wrap; }</style>\n<main id=\"content\">\n<h1>" +
                       text(row.student) + "</h1>\n" + fmt::format("<p>{:.1f} % in all.</p>\n", row.total);
    for (std::size_t i = 0; i < row.results.size(); ++i)
        body += row.results[i].grade ? grade_html(row.results[i])
                                     : "<h2>Exercise " + text(table.assignments[i].assignment.exercise->folder) +
                                           "</h2>\n<p>Nothing.</p>\n";
    return whole_page({.title = row.student}, "", body + "</main>\n");
}

}  // namespace raylab::grading
