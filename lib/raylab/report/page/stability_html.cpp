#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"

namespace raylab {

std::string stability_html(const std::vector<CaseOutcome>& outcomes) {
    std::string html;
    for (const auto& outcome : outcomes) {
        html += "<h3 id=\"" + anchor_name(outcome.name) + "\">" + escape_html(outcome.name) + "</h3>\n" +
                html_from_markdown(outcome.about) +
                "<div class=\"scroll wide\" tabindex=\"0\"><table>\n<thead><tr><th scope=\"col\">method</th><th "
                "scope=\"col\">expected</th><th scope=\"col\">observed</th><th "
                "scope=\"col\">verdict</th></tr></thead>\n<tbody>\n";
        for (const auto& row : outcome.rows)
            html += std::string("<tr") + (row.as_expected ? "" : " class=\"unexpected\"") + "><th scope=\"row\">" +
                    escape_html(row.method) + "</th><td>" + escape_html(row.expected) + "</td><td>" +
                    escape_html(row.observed) + "</td><td class=\"verdict " + (row.as_expected ? "good" : "bad") +
                    "\">" + verdict_text(row) + "</td></tr>\n";
        html += "</tbody></table></div>\n";
    }
    return html;
}

}  // namespace raylab
