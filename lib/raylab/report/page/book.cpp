#include "raylab/report/page/book.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/read_json.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/index_page.h"
#include "raylab/report/page/page_parts.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

namespace raylab {

namespace fs = std::filesystem;

namespace {

const char* const introduction =
    "Ray tracing, one question a chapter. No answer here has to be believed: each has an exact truth behind it, a "
    "cost measured beside it, and cases where the usual methods fail, found on purpose. All pictures and numbers "
    "were made on this machine, by the programs they describe.";

const char* const next_steps =
    "```\n"
    "./raylab chapter 03              one chapter again\n"
    "./raylab chart                   the questions; with one of them: its chart of speed against accuracy\n"
    "./raylab stability               the failure cases: expected, observed, verdict\n"
    "./raylab check 01                your own answer to the first exercise, judged in seconds\n"
    "```\n";

std::string picture_of(const fs::path& folder, const BookEntry& entry) {
    if (entry.picture.empty() || !entry.problem.empty()) return "<div class=\"picture\"></div>\n";
    const auto file = entry.folder + "/" + entry.picture;
    if (!fs::exists(folder / file))
        throw Error({(folder / file).string()}, "the chapter's first picture", "nothing there");
    return std::string("<div class=\"picture") + (is_drawing(file) ? " drawn" : "") + "\"><img src=\"" +
           escape_html(file) + "\" alt=\"" + escape_html(entry.picture_shows) + "\"></div>\n";
}

std::string card_html(const fs::path& folder, const BookEntry& entry) {
    std::string verdict;
    if (!entry.problem.empty())
        verdict = "<span class=\"chip bad\">✗ did not run</span>";
    else if (entry.cases > 0)
        verdict = verdict_chip(entry.cases_as_expected, entry.cases);
    return "<li class=\"card\">" + picture_of(folder, entry) + "<div class=\"words\"><p class=\"number\">Chapter " +
           escape_html(entry.folder.substr(0, 2)) + "</p>\n<h2><a href=\"" + escape_html(entry.folder) +
           "/index.html\">" + escape_html(entry.title) + "</a></h2>\n<p class=\"question\">" +
           escape_html(entry.question) + "</p>\n<p>" + verdict + " <span class=\"took\">" +
           duration_text(1e9 * entry.seconds) + "</span></p></div></li>\n";
}

std::string cover_html() {
    return std::string("<img class=\"cover\" src=\"") + book_cover +
           "\" width=\"1600\" height=\"700\" alt=\"A framed mirror, a ball of glass, and what is seen in them\">\n";
}

std::string front_page_html(const fs::path& folder, const std::vector<BookEntry>& entries,
                            const std::vector<Fact>& facts) {
    std::string body =
        "<header class=\"front\">\n<p class=\"number\">raylab</p>\n<h1>The lab book</h1>\n<p "
        "class=\"question\">" +
        escape_html(introduction) + "</p>\n" + cover_html() +
        "<p><a href=\"glossary.html\">Words and symbols, methods, failure cases</a> · <a href=\"" + book_mistakes +
        "\">Typical mistakes, and what the grader says to them</a></p>\n</header>\n<main id=\"content\">\n<ul class=\"cards "
        "wide\">\n";
    for (const auto& entry : entries) body += card_html(folder, entry);
    body += "</ul>\n<h2>What to try next</h2>\n" + html_from_markdown(next_steps) +
            "</main>\n<footer>Made on this machine\n" + facts_html(facts) + "</footer>\n";
    return whole_page({.title = "raylab lab book", .kind = "front"}, "", body);
}

}  // namespace

BookEntry read_entry(const fs::path& chapter_folder) {
    const auto page = read_json(chapter_folder / "page.json");
    return {.folder = page.at("folder"),
            .title = page.at("title"),
            .question = page.at("question"),
            .picture = page.at("picture"),
            .picture_shows = page.at("picture_shows"),
            .charts = page.at("charts").get<std::vector<std::string>>(),
            .cases = page.at("cases"),
            .cases_as_expected = page.at("cases_as_expected"),
            .seconds = page.at("seconds")};
}

void write_problem_page(const fs::path& chapter_folder, const BookEntry& entry) {
    const auto body = "<header><p class=\"number\">Chapter " + escape_html(entry.folder.substr(0, 2)) + "</p>\n<h1>" +
                      escape_html(entry.title) + "</h1>\n<p class=\"question\">" + escape_html(entry.question) +
                      "</p></header>\n<main id=\"content\"><p><span class=\"chip bad\">✗ This chapter did not "
                      "run</span> " +
                      escape_html(entry.problem) + "</p>\n" +
                      html_from_markdown("`./raylab chapter " + entry.folder.substr(0, 2) + "` says more.") +
                      "</main>\n";
    write_file(chapter_folder / "index.html",
               whole_page({.title = entry.title + " · raylab lab book"}, way_to_front_page("../index.html"), body));
}

std::vector<BookFile> book_files(const fs::path& folder, const std::vector<BookEntry>& entries,
                                 const std::vector<Fact>& facts) {
    const auto index = index_entries(folder, entries);
    return {{"index.html", front_page_html(folder, entries, facts)},
            {"glossary.html", index_html(index)},
            {"search.js", search_script(index)}};
}

}  // namespace raylab
