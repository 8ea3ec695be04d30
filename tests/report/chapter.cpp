#include "raylab/report/chapter.h"

#include "catch.h"
#include "raylab/base/file.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <filesystem>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

constexpr auto lesson_text = R"(# 99 Demo

![An "empty" drawing](pictures/a.svg)

## First

Some *text*.

<!-- table: numbers -->
| n | v |
|---|---|
| a | 0 |

## Speed against accuracy

<!-- chart: q1 -->
<!-- chart: q2 -->

## Where it fails

<!-- cases -->
| case |
|---|
| GOOD |
)";

/// A folder for one test, which is removed with it.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_report_" + std::to_string(::getpid()));
    fs::path lesson = path.string() + ".md";
    Folder() {
        fs::create_directories(path);
        write_file(lesson, lesson_text);
    }
    ~Folder() {
        fs::remove_all(path);
        fs::remove(lesson);
    }
};

Experiment experiment(const std::string& question) {
    return {question,
            "Is <it> right?",
            "wrong [ppm]",
            {{.method = "M & M",
              .number = "float",
              .workload = "w",
              .error = 0,
              .error_bound = 30,
              .nanoseconds = {1, 1, 1},
              .queries = 100'000}}};
}

Chapter chapter() {
    return {.title = {"99_demo", "Demo <b>", "Does it work & how?"},
            .story =
                [](const ChapterRun&, Page& page) {
                    page.figure("a", [] { return PlaneDrawing{}; });
                    page.table("numbers", {"n", "v"}, [] { return Page::Rows{{"a", "1"}}; });
                },
            .questions = {{"q1", [](const ChapterRun&) { return experiment("q1"); }},
                          {"q2", [](const ChapterRun&) { return experiment("q2"); }}},
            .cases =
                [](const ChapterRun&) {
                    return std::vector<StabilityCase>{
                        {"GOOD", "holds",
                         [] {
                             return std::vector<CaseRow>{{"m", "fails: wrong", "wrong", true}};
                         }},
                        {"BAD", "does not", [] {
                             return std::vector<CaseRow>{{"m", "fails: wrong", "right", false}};
                         }}};
                }};
}

int run(const Folder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), "demo");
    if (std::ranges::find(words, "--list") == words.end())
        words.insert(words.end(), {"--out", folder.path, "--lesson", folder.lesson});
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    return run_chapter(chapter(), static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace

TEST_CASE("a chapter writes its page, its charts' data and its cases, and exits 1 where a case is not as expected") {
    const Folder folder;
    CHECK(run(folder, {"--json", folder.path / "all.json"}) == 1);
    const auto page = read_file(folder.path / "99_demo/index.html");
    CHECK(page.find("Demo &lt;b&gt;") != std::string::npos);
    CHECK(page.find("<b>") == std::string::npos);
    CHECK(page.find("An &quot;empty&quot; drawing") != std::string::npos);
    CHECK(page.find("‼ HOLDS, should fail") != std::string::npos);
    const auto all = nlohmann::json::parse(read_file(folder.path / "all.json"));
    CHECK(all["questions"].size() == 2);
    CHECK(all["stability"][1]["as_expected"] == false);
    const auto summary = nlohmann::json::parse(read_file(folder.path / "99_demo/page.json"));
    CHECK(summary["picture"] == "a.svg");
    CHECK(summary["cases"] == 2);
    CHECK(summary["cases_as_expected"] == 1);
    CHECK(fs::exists(folder.path / "99_demo/q2.csv"));
    CHECK(fs::exists(folder.path / "99_demo/stability.json"));
}

TEST_CASE("one case alone is judged alone, and writes no page") {
    const Folder folder;
    CHECK(run(folder, {"--case", "GOOD"}) == 0);
    CHECK(run(folder, {"--case", "BAD", "--case", "GOOD"}) == 1);
    CHECK(!fs::exists(folder.path / "99_demo/index.html"));
    CHECK(!fs::exists(folder.path / "99_demo/q1.csv"));
}

TEST_CASE("one question alone writes its chart alone") {
    const Folder folder;
    CHECK(run(folder, {"--question", "q1"}) == 0);
    CHECK(fs::exists(folder.path / "99_demo/q1.csv"));
    CHECK(!fs::exists(folder.path / "99_demo/q2.csv"));
}

TEST_CASE("a method is called `yours` where the slot that it asks has a student's function in it, and only there") {
    const ChapterRun with{.yours = "light_cell"}, without;
    CHECK(with.name_of("light_cell", "conservative") == "yours");
    CHECK(with.name_of("listed_cells", "textbook") == "textbook");
    CHECK(without.name_of("light_cell", "conservative") == "conservative");
    CHECK_FALSE(without.is_yours(""));
    const Folder folder;
    CHECK(run(folder, {"--only", "story", "--yours", "light_cell"}) == 0);
    CHECK(read_file(folder.path / "99_demo/index.html").find("your light_cell()") != std::string::npos);
}

TEST_CASE("what a chapter does not know is refused with exit 2, and nothing is written") {
    const Folder folder;
    CHECK(run(folder, {"--only", "everything"}) == 2);
    CHECK(run(folder, {"--question", "q3"}) == 2);
    CHECK(run(folder, {"--case", "MISSING"}) == 2);
    CHECK(run(folder, {"--seed", "-1"}) == 2);
    CHECK(run(folder, {"--unknown"}) == 2);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("listing runs nothing") {
    const Folder folder;
    CHECK(run(folder, {"--list"}) == 0);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a page in the book links to its neighbours and the front page, alone to nothing") {
    const Folder folder;
    run(folder, {"--only", "story", "--in-book", "--previous", "98_before", "--next", "100_after"});
    const auto in_book = read_file(folder.path / "99_demo/index.html");
    CHECK(in_book.find("href=\"../98_before/index.html\"") != std::string::npos);
    CHECK(in_book.find("href=\"../100_after/index.html\"") != std::string::npos);
    CHECK(in_book.find("href=\"../index.html\"") != std::string::npos);
    run(folder, {"--only", "story"});
    CHECK(read_file(folder.path / "99_demo/index.html").find("href=\"../") == std::string::npos);
}

TEST_CASE("one figure alone is made alone, and its table not at all") {
    const Folder folder;
    int made = 0;
    Page page({"99_demo", "Demo", "?"}, {.out = folder.path, .figure = "b"});
    page.figure("a", [&] { return ++made, PlaneDrawing{}; });
    page.figure("b", [] { return PlaneDrawing{}; });
    page.table("numbers", {"n"}, [&] { return ++made, Page::Rows{}; });
    CHECK(made == 0);
    CHECK(fs::exists(folder.path / "b.svg"));
    CHECK(page.offered() == std::vector<std::string>{"a", "b"});
    CHECK(run(folder, {"--figure", "a"}) == 0);
    CHECK(fs::exists(folder.path / "99_demo/a.svg"));
    CHECK(!fs::exists(folder.path / "99_demo/index.html"));
    CHECK(run(folder, {"--figure", "missing"}) == 2);
}
