#include "raylab/report/page/book.h"

#include "catch.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/chapter.h"
#include "raylab/report/page/drawing_size.h"

#include <unistd.h>

#include <filesystem>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_book_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

/// The targets of a page's href or src attributes, in their order.
std::vector<std::string> links_of(const std::string& html) {
    std::vector<std::string> links;
    for (const std::string attribute : {"href=\"", "src=\""})
        for (auto at = html.find(attribute); at != std::string::npos; at = html.find(attribute, at + 1)) {
            const auto begin = at + attribute.size();
            links.push_back(html.substr(begin, html.find('"', begin) - begin));
        }
    return links;
}

std::size_t check_links(const fs::path& page) {
    const auto html = read_file(page);
    const auto links = links_of(html);
    for (const auto& link : links) {
        INFO(page << " links to " << link);
        if (link.starts_with("#"))
            CHECK(html.find("id=\"" + link.substr(1) + "\"") != std::string::npos);
        else
            CHECK(fs::exists(page.parent_path() / link));
    }
    return links.size();
}

BookEntry write_chapter(const fs::path& folder, const std::string& name, const ChapterRun& run) {
    auto told = run;
    told.out = folder / name;
    told.lesson = folder / "README.md";
    write_file(told.lesson, "# 01 A chapter\n\n![A drawing](pictures/a.svg)\n\n## Same words\n\n## Same words\n");
    Page page({name, "A <chapter>", "Why?"}, told);
    page.figure("a", [] { return PlaneDrawing{}; });
    page.write(told.out);
    return read_entry(folder / name);
}

void write_book(const fs::path& folder, const std::vector<BookEntry>& entries, const std::vector<Fact>& facts) {
    for (const auto& [name, text] : book_files(folder, entries, facts)) write_file(folder / name, text);
}

}  // namespace

TEST_CASE("a chart may not take a figure's name, whose file it would replace") {
    const Folder folder;
    ChapterRun run;
    run.out = folder.path;
    Page page({"99_demo", "Demo", "Why?"}, run);
    page.figure("same", [] { return PlaneDrawing{}; });
    CHECK_THROWS_AS(page.experiment({}, "same"), Error);
}

TEST_CASE("every link of the lab book leads somewhere, also to a chapter that did not run") {
    const Folder folder;
    constexpr auto in_book = ChapterRun::Place::in_book;
    std::vector<BookEntry> entries;
    entries.push_back(write_chapter(folder.path, "01_first", {.place = in_book, .previous = "", .next = "02_second"}));
    entries.push_back(
        write_chapter(folder.path, "02_second", {.place = in_book, .previous = "01_first", .next = "03_broken"}));
    entries.push_back({.folder = "03_broken", .title = "Broken", .question = "?", .problem = "exit code 2 <x>"});
    write_problem_page(folder.path / "03_broken", entries.back());
    for (const auto* by_the_tour : {book_cover, book_mistakes}) write_file(folder.path / by_the_tour, "");
    write_book(folder.path, entries, machine_facts());

    CHECK(check_links(folder.path / "index.html") >= 3);
    CHECK(check_links(folder.path / "01_first/index.html") >= 4);
    CHECK(check_links(folder.path / "02_second/index.html") >= 5);
    CHECK(check_links(folder.path / "03_broken/index.html") >= 1);
}

TEST_CASE("the front page escapes what chapters say, and shows each verdict in words") {
    const Folder folder;
    auto entry = write_chapter(folder.path, "01_first", {});
    CHECK(entry.title == "A <chapter>");
    entry.cases = 3;
    entry.cases_as_expected = 2;
    write_book(folder.path, {entry}, {{"processor", "<fast> & \"new\""}});
    const auto html = read_file(folder.path / "index.html");
    CHECK(html.find("A &lt;chapter&gt;") != std::string::npos);
    CHECK(html.find("✗ 2 of 3 failure cases as expected") != std::string::npos);
    CHECK(html.find("&lt;fast&gt; &amp; &quot;new&quot;") != std::string::npos);
}

TEST_CASE("pages stand alone: style and script are inside, and nothing comes from elsewhere") {
    const Folder folder;
    write_book(folder.path, {write_chapter(folder.path, "01_first", {})}, {});
    for (const auto* page : {"index.html", "glossary.html", "01_first/index.html"}) {
        const auto html = read_file(folder.path / page);
        CHECK(html.find("<script>") != std::string::npos);
        CHECK(html.find("<script src") == std::string::npos);
        for (const auto& link : links_of(html)) CHECK(!link.starts_with("http"));
        CHECK(html.find("@import") == std::string::npos);
    }
}

TEST_CASE("the index has words before symbols, by the alphabet, with links to where they are defined") {
    const Folder folder;
    auto entry = write_chapter(folder.path, "01_first", {});
    write_file(folder.path / "01_first/page.json",
               R"({"words": [{"term": "ulp", "html": "<strong>ulp</strong>: a unit", "anchor": "term-ulp"},
                             {"term": "<math><mi>c</mi></math>", "html": "<math><mi>c</mi></math>: a cosine", "anchor": "word-c"},
                             {"term": "Eye ray", "html": "<strong>Eye ray</strong>: from the eye", "anchor": "term-eye-ray"}],
                   "methods": [{"name": "a <b>", "anchor": "chart-one"}, {"name": "a <b>", "anchor": "chart-two"}],
                   "case_names": ["SHARED-EDGE"], "headings": [{"words": "A &amp; B", "anchor": "a-b"}]})");
    write_book(folder.path, {entry}, {});
    const auto html = read_file(folder.path / "glossary.html");
    const auto at = [&](const std::string& text) {
        INFO(text);
        REQUIRE(html.find(text) != std::string::npos);
        return html.find(text);
    };
    CHECK(at("from the eye (<a href=\"01_first/index.html#term-eye-ray\">") < at("a unit (<a href"));
    CHECK(at("a unit (") < at("a cosine ("));
    CHECK(at("a cosine (") < at("a &lt;b&gt;: <a href=\"01_first/index.html#chart-one\">chapter 01</a>, <a"));
    CHECK(at("SHARED-EDGE: <a href=\"01_first/index.html#shared-edge\">") > at("chart-two"));
    const auto search = read_file(folder.path / "search.js");
    CHECK(search.find(R"(["part","A & B","01_first/index.html#a-b","chapter 01"])") != std::string::npos);
    CHECK(search.find(R"(["word","c: a cosine","01_first/index.html#word-c","chapter 01"])") != std::string::npos);
}

TEST_CASE("a drawing's size and smallest letter are read from its file") {
    const auto size =
        drawing_size("<?xml?><svg width=\"100pt\" viewBox=\"0.00 0.00 300.00 200.50\"><g font-size=\"14.00\"/>"
                     "<text x=\"1\" font-size=\"9.5\">a<tspan font-size=\"6\">b</tspan></text></svg>");
    REQUIRE(size);
    CHECK(size->width == 300);
    CHECK(size->height == 200.5);
    CHECK(size->smallest_letter == 9.5);
    CHECK(!drawing_size("<svg xmlns=\"\"/>"));
}

TEST_CASE("a picture that is not there keeps the front page from being written") {
    const Folder folder;
    auto entry = write_chapter(folder.path, "01_first", {});
    entry.picture = "missing.png";
    CHECK_THROWS(write_book(folder.path, {entry}, {}));
    CHECK(!fs::exists(folder.path / "index.html"));
}
