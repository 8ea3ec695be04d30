#include "raylab/report/page/page.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/json_text.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/lesson_links.h"
#include "raylab/report/page/page_parts.h"
#include "raylab/report/page/pixel_values.h"
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
    if (!run.yours.empty()) facts.push_back({"function", "your " + run.yours + "(), in place of the reference"});
    facts.push_back({"time", duration_text(1e9 * seconds)});
    return facts;
}

// The writers of the kinds of figures: each returns the file's name.
class FigureWriter {
public:
    FigureWriter(const fs::path& folder, const std::string& name) : folder_(folder), name_(name) {}

    std::string operator()(const Image& image) const {
        write_image(image, folder_ / (name_ + ".png"));
        write_file(folder_ / pixel_values_file(name_ + ".png"), pixel_values_script(image));
        return name_ + ".png";
    }
    std::string operator()(const PlaneDrawing& drawing) const {
        write_svg(drawing, folder_ / (name_ + ".svg"));
        return name_ + ".svg";
    }
    std::string operator()(const Diagram& diagram) const {
        write_diagram(diagram, folder_ / (name_ + ".svg"));
        return name_ + ".svg";
    }
    std::string operator()(const CurveChart& chart) const {
        write_chart(chart, folder_, name_);
        return name_ + ".svg";
    }

private:
    fs::path folder_;
    std::string name_;
};

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

std::string side_contents(const Lesson& lesson) {
    std::string html = "<nav class=\"side\" aria-label=\"Contents\"><ul>\n";
    for (const auto& [words, anchor] : lesson.headings)
        html += "<li><a href=\"#" + anchor + "\">" + words + "</a></li>\n";
    return html + "<li><a href=\"#this-run\">This run</a></li></ul></nav>\n";
}

nlohmann::ordered_json to_json(const Lesson& lesson) {
    const auto first = lesson.figures.empty() ? Lesson::Figure{} : lesson.figures.front();
    nlohmann::ordered_json json = {{"picture", first.file},
                                   {"picture_shows", first.caption},
                                   {"headings", nlohmann::ordered_json::array()},
                                   {"figures", nlohmann::ordered_json::array()},
                                   {"words", nlohmann::ordered_json::array()}};
    for (const auto& [words, anchor] : lesson.headings)
        json["headings"].push_back({{"words", words}, {"anchor", anchor}});
    for (const auto& [name, file, caption, anchor] : lesson.figures)
        json["figures"].push_back({{"name", name}, {"file", file}, {"caption", caption}, {"anchor", anchor}});
    for (const auto& [term, html, anchor] : lesson.words)
        json["words"].push_back({{"term", term}, {"html", html}, {"anchor", anchor}});
    return json;
}

}  // namespace

Page::Page(const ChapterTitle& title, const ChapterRun& run)
    : title_(title), run_(run), begun_(std::chrono::steady_clock::now()) {}

void Page::figure(const std::string& name, const std::function<Drawing()>& make, const FigureOptions& options) {
    offered_.push_back(name);
    if (!run_.figure.empty() && run_.figure != name) return;
    const auto drawing = make();
    LessonParts::Figure made{.file = std::visit(FigureWriter(run_.out, name), drawing), .command = options.command};
    if (made.command.empty()) made.command = "./raylab chapter " + number_of(title_.folder) + " --figure " + name;
    if (options.keep == Keep::floats && run_.place == ChapterRun::Place::alone) {
        made.floats = name + ".exr";
        write_image(std::get<Image>(drawing), run_.out / made.floats);
    }
    parts_.figures[name] = made;
}

void Page::pixel_trees(const std::string& figure, const std::function<std::string()>& make) {
    if (!run_.figure.empty()) return;
    parts_.figures.at(figure).trees = figure + "_trees.js";
    write_file(run_.out / parts_.figures.at(figure).trees, make());
}

void Page::walk_through(const std::string& figure, const std::function<std::string()>& make) {
    if (!run_.figure.empty()) return;
    parts_.figures.at(figure).walk = figure + "_walk.html";
    write_file(run_.out / parts_.figures.at(figure).walk, make());
}

void Page::table(const std::string& name, const std::vector<std::string>& header, const std::function<Rows()>& make) {
    if (run_.figure.empty()) parts_.tables[name] = table_html(header, make(), "");
}

void Page::experiment(const Experiment& experiment, const std::string& chart_name) {
    if (std::ranges::find(offered_, chart_name) != offered_.end())
        throw Error({run_.lesson.string()}, "a chart and a figure to have names, and so files, of their own",
                    "'" + chart_name + "' twice");
    charts_.push_back(chart_name);
    for (const auto& row : experiment.rows) {
        const std::pair method{row.method, chart_name};
        if (std::ranges::find(methods_, method) == methods_.end()) methods_.push_back(method);
    }
    parts_.charts[chart_name] = experiment_html(run_.out, experiment, chart_name);
}

void Page::stability(const std::vector<CaseOutcome>& outcomes) {
    outcomes_ = outcomes;
    parts_.cases = stability_html(outcomes);
}

nlohmann::ordered_json Page::summary() const {
    const auto as_expected = std::ranges::count_if(outcomes_, &CaseOutcome::as_expected);
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& outcome : outcomes_) names.push_back(outcome.name);
    nlohmann::ordered_json methods = nlohmann::ordered_json::array();
    for (const auto& [name, chart] : methods_) methods.push_back({{"name", name}, {"anchor", "chart-" + chart}});
    return {{"folder", title_.folder},
            {"title", title_.title},
            {"question", title_.question},
            {"charts", charts_},
            {"cases", outcomes_.size()},
            {"cases_as_expected", as_expected},
            {"case_names", names},
            {"methods", methods},
            {"effort", run_.effort == ChapterRun::Effort::full ? "full" : "quick"},
            {"seed", run_.seed},
            {"seconds", seconds_since(begun_)}};
}

void Page::write(const fs::path& folder) const {
    const auto lesson = read_lesson(run_.lesson, parts_, folder, run_.place);
    const auto number = number_of(title_.folder);
    const auto body = "<header>\n<p class=\"number\">Chapter " + number + "</p>\n<h1>" + escape_html(title_.title) +
                      "</h1>\n<p class=\"question\">" + escape_html(title_.question) + "</p>\n</header>\n" +
                      side_contents(lesson) + "<main id=\"content\">\n<section class=\"part introduction\">\n" +
                      lesson.introduction + "</section>\n" + lesson.body +
                      "</main>\n<footer id=\"this-run\">The numbers of this run and this machine\n" +
                      facts_html(facts_of(run_, seconds_since(begun_))) + "</footer>\n";
    for (const auto& source : lesson.sources) write_file(folder / source_copy(source), read_file(source));
    write_file(
        folder / "index.html",
        whole_page({.title = number + " " + title_.title + " · raylab lab book", .kind = "lesson", .chapter = number},
                   navigation(run_), body));
    auto json = summary();
    json.update(to_json(lesson));
    write_file(folder / "page.json", json_text(json));
}

}  // namespace raylab
