#include "raylab/base/file.h"
#include "raylab/report/chapter.h"
#include "raylab/report/json_text.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// "02_spheres_and_quadrics" is chapter "02".
std::string number_of(const std::string& folder) { return folder.substr(0, folder.find('_')); }

// "03_triangles_and_polygons" reads "03 triangles and polygons".
std::string words_of(std::string folder) {
    std::ranges::replace(folder, '_', ' ');
    return folder;
}

std::string neighbour(const std::string& folder, const std::string& rel, const std::string& before,
                      const std::string& after) {
    if (folder.empty()) return "<span></span>";
    return "<span><a rel=\"" + rel + "\" href=\"../" + escape_html(folder) + "/index.html\">" + before +
           escape_html(words_of(folder)) + after + "</a></span>";
}

// The links to the neighbouring chapters and the front page. A chapter that was run alone has none.
std::string navigation(const ChapterRun& run) {
    if (run.place == ChapterRun::Place::alone) return "";
    return "<nav class=\"book\" aria-label=\"Chapters\">" + neighbour(run.previous, "prev", "← ", "") +
           "<span><a href=\"../index.html\">Lab book</a></span>" + neighbour(run.next, "next", "", " →") + "</nav>\n";
}

std::vector<Fact> facts_of(const ChapterRun& run, double seconds) {
    auto facts = machine_facts();
    facts.push_back(
        {"run", run.effort == ChapterRun::Effort::full ? "full" : "quick: fewer samples, smaller pictures"});
    facts.push_back({"seed", std::to_string(run.seed)});
    facts.push_back({"threads", run.threads > 0 ? std::to_string(run.threads) : "all cores"});
    if (run.slot == ChapterRun::Slot::yours) facts.push_back({"function", "yours, in place of the reference"});
    facts.push_back({"time", duration_text(1e9 * seconds)});
    return facts;
}

}  // namespace

Page::Page(const ChapterTitle& title) : title_(title), begun_(std::chrono::steady_clock::now()) {}

void Page::heading(const std::string& text) {
    // Two headings with the same words need different names.
    auto name = anchor_name(text);
    for (int again = 2; std::ranges::find(headings_, name, &Heading::anchor) != headings_.end(); ++again)
        name = anchor_name(text) + "-" + std::to_string(again);
    headings_.push_back({text, name});
    const auto html = "<h2 id=\"" + name + "\">" + html_from_markdown_line(text) + "</h2>\n";
    blocks_.push_back([html](const fs::path&) { return html; });
}

void Page::text(const std::string& markdown) {
    blocks_.push_back([html = html_from_markdown(markdown)](const fs::path&) { return html; });
}

void Page::figures(const std::vector<Figure>& figures) {
    if (first_picture_.file.empty() && !figures.empty()) first_picture_ = figures.front();
    const int first_step = steps_ + 1;
    steps_ += static_cast<int>(figures.size());
    blocks_.push_back([=](const fs::path& folder) {
        std::string html = "<div class=\"steps wide\">\n";
        int step = first_step;
        for (const auto& [file, caption] : figures)
            html += std::string("<figure") + (is_drawing(file) ? " class=\"drawing\"" : "") + ">" +
                    picture_html(folder, file, caption) + "<figcaption><span class=\"step\">" + std::to_string(step++) +
                    "</span>" + html_from_markdown_line(caption) + "</figcaption></figure>\n";
        return html + "</div>\n";
    });
}

void Page::table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                 const std::string& caption) {
    blocks_.push_back([html = table_html(header, rows, caption)](const fs::path&) { return html; });
}

void Page::experiment(const Experiment& experiment, const std::string& chart_name) {
    charts_.push_back(chart_name);
    blocks_.push_back([=](const fs::path& folder) {
        return "<h3>" + escape_html(experiment.title) + "</h3>\n" + experiment_html(folder, experiment, chart_name);
    });
}

void Page::stability(const std::vector<CaseOutcome>& outcomes) {
    cases_ += outcomes.size();
    cases_as_expected_ += static_cast<std::size_t>(std::ranges::count_if(outcomes, &CaseOutcome::as_expected));
    blocks_.push_back([html = stability_html(outcomes)](const fs::path&) { return html; });
}

void Page::write(const fs::path& folder, const ChapterRun& run) const {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
    std::string body = "<header>\n<p class=\"number\">Chapter " + number_of(title_.folder) + "</p>\n<h1>" +
                       escape_html(title_.title) + "</h1>\n<p class=\"question\">" + escape_html(title_.question) +
                       "</p>\n<ul class=\"contents\">";
    for (const auto& [words, anchor] : headings_)
        body += "<li><a href=\"#" + anchor + "\">" + html_from_markdown_line(words) + "</a></li>";
    body += "<li><a href=\"#this-run\">This run</a></li></ul>\n</header>\n<main id=\"content\">\n";
    for (const auto& block : blocks_) body += block(folder);
    body += "</main>\n<footer id=\"this-run\">The numbers of this run and this machine\n" +
            facts_html(facts_of(run, taken.count())) + "</footer>\n";
    write_file(folder / "index.html",
               whole_page(number_of(title_.folder) + " " + title_.title + " · raylab lab book", navigation(run), body));

    const nlohmann::ordered_json json = {{"folder", title_.folder},
                                         {"title", title_.title},
                                         {"question", title_.question},
                                         {"picture", first_picture_.file},
                                         {"picture_shows", first_picture_.caption},
                                         {"charts", charts_},
                                         {"cases", cases_},
                                         {"cases_as_expected", cases_as_expected_},
                                         {"effort", run.effort == ChapterRun::Effort::full ? "full" : "quick"},
                                         {"seed", run.seed},
                                         {"seconds", taken.count()}};
    write_file(folder / "page.json", json_text(json));
}

}  // namespace raylab
