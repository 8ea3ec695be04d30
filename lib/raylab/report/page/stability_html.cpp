#include "raylab/report/page/html.h"
#include "raylab/report/page/inline_svg.h"
#include "raylab/report/page/page_parts.h"

#include <algorithm>

namespace raylab {

namespace {

// The class of a row, by which the style sheet colours it.
std::string class_of(const CaseRow& row) {
    if (!row.as_expected) return "unexpected";
    switch (expectation_of(row)) {
        case Expectation::fails:
            return "fails";
        case Expectation::holds:
            return "holds";
        case Expectation::nothing:
            break;
    }
    return "shown";
}

std::string row_html(const CaseRow& row) {
    return "<tr class=\"" + class_of(row) + "\"><td class=\"verdict\">" + verdict_text(row) +
           "</td><th scope=\"row\">" + escape_html(row.method) + "</th><td>" + escape_html(expected_words(row)) +
           "</td><td>" + escape_html(row.observed) +
           (row.example ? "<details><summary>a ray that shows it</summary><code>" + escape_html(row.example->words) +
                              "</code></details>"
                        : "") +
           "</td></tr>\n";
}

std::string thumbnail_html(const std::string& name, const CaseSketch& sketch) {
    return "<figure class=\"drawing thumbnail\">" + inline_svg(to_svg(sketch.drawing), "case-" + name, sketch.caption) +
           "<figcaption>" + escape_html(sketch.caption) + "</figcaption></figure>\n";
}

// The first example of a case: of a row that fails, or of one that is only shown if there is no other.
auto shown_example(const std::vector<CaseRow>& rows) {
    const auto fails = std::ranges::find_if(rows, [](const CaseRow& row) {
        return row.example && (!row.as_expected || expectation_of(row) == Expectation::fails);
    });
    if (fails != rows.end()) return fails;
    return std::ranges::find_if(rows, [](const CaseRow& row) { return row.example.has_value(); });
}

std::string thumbnails_html(const CaseOutcome& outcome) {
    std::string html;
    const auto example = shown_example(outcome.rows);
    if (example != outcome.rows.end())
        html += thumbnail_html(outcome.name + "-example",
                               {example->method + " is wrong about this ray.", example->example->drawing});
    if (outcome.sketch) html += thumbnail_html(outcome.name, *outcome.sketch);
    return html;
}

}  // namespace

std::string stability_html(const std::vector<CaseOutcome>& outcomes) {
    std::string html;
    for (const auto& outcome : outcomes) {
        html += "<section class=\"case\" id=\"" + anchor_name(outcome.name) + "\">\n<h3>" + escape_html(outcome.name) +
                "</h3>\n" + html_from_markdown(outcome.about) + thumbnails_html(outcome) +
                "<div class=\"scroll wide\" tabindex=\"0\"><table>\n<thead><tr><th scope=\"col\">verdict</th><th "
                "scope=\"col\">method</th><th scope=\"col\">expected</th><th "
                "scope=\"col\">observed</th></tr></thead>\n<tbody>\n";
        for (const auto& row : outcome.rows) html += row_html(row);
        html += "</tbody></table></div>\n</section>\n";
    }
    return html;
}

}  // namespace raylab
