#include "raylab/report/page/lesson.h"

#include "catch.h"
#include "raylab/base/file.h"
#include "raylab/report/page/lesson_links.h"
#include "raylab/report/provenance.h"

#include <unistd.h>

using namespace raylab;
namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// A page's folder with one figure, and a lesson beside it.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_lesson_" + std::to_string(::getpid()));
    LessonParts parts{.figures = {{"a", {"a.svg", "", "./raylab chapter 99 --figure a"}}},
                      .tables = {{"numbers", "<table>of this run</table>"}},
                      .charts = {{"q1", "<figure id=\"chart-q1\"></figure>"}},
                      .cases = "<section class=\"case\" id=\"GOOD\"></section>"};
    Folder() { write_file(path / "a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"); }
    ~Folder() { fs::remove_all(path); }

    Lesson read(const std::string& text, ChapterRun::Place place = ChapterRun::Place::alone) const {
        write_file(path / "README.md", text);
        return read_lesson(path / "README.md", parts, path, place);
    }
};

const std::string whole = R"(# 99 Demo: why?

An introduction.

## An idea

![What *it* shows](pictures/a.png)

A **term** is defined.

<!-- table: numbers -->
| n |
|---|
| of the last full run |

## Speed against accuracy

<!-- chart: q1 -->

## Where it fails

<!-- cases -->
| case |
|---|
| GOOD |

## Words and symbols

- **term**: a word.
- $a$, $b$: two symbols.
)";

}  // namespace

TEST_CASE("a lesson gets this run's figures, tables, charts and cases where it names them") {
    const Folder folder;
    const auto lesson = folder.read(whole);
    CHECK_THAT(lesson.introduction, Contains("<p>An introduction.</p>"));
    CHECK_THAT(lesson.body, Contains("<figure id=\"fig-a\" class=\"drawing\">"));
    CHECK_THAT(lesson.body, Contains("What <em>it</em> shows"));
    CHECK_THAT(lesson.body, Contains("alt=\"What it shows\""));
    CHECK_THAT(lesson.body, Contains("<code>./raylab chapter 99 --figure a</code>"));
    CHECK_THAT(lesson.body, Contains("<table>of this run</table>"));
    CHECK_THAT(lesson.body, Contains("chart-q1"));
    CHECK_THAT(lesson.body, Contains("id=\"GOOD\""));
    CHECK_THAT(lesson.body, !Contains("of the last full run"));
    CHECK_THAT(lesson.body, !Contains("<td>GOOD</td>"));
}

TEST_CASE("a lesson's contents are data") {
    const Folder folder;
    const auto lesson = folder.read(whole);
    REQUIRE(lesson.headings.size() == 4);
    CHECK(lesson.headings[1].anchor == "speed-against-accuracy");
    REQUIRE(lesson.figures.size() == 1);
    CHECK(lesson.figures[0].caption == "What it shows");
    REQUIRE(lesson.words.size() == 2);
    CHECK(lesson.words[0].term == "term");
    CHECK(lesson.words[0].anchor == "term-term");
    CHECK_THAT(lesson.words[1].term, Contains("a") && Contains("b") && !Contains("two"));
    CHECK_THAT(lesson.body, Contains("<strong class=\"term\" id=\"term-term\">term</strong> is defined"));
    CHECK_THAT(lesson.body, Contains("<section id=\"an-idea\" class=\"part core\">"));
    CHECK_THAT(lesson.body, Contains("class=\"part where-it-fails\""));
}

TEST_CASE("where the cases and charts did not run, the lesson says so and keeps its table of cases") {
    Folder folder;
    folder.parts.cases.clear();
    folder.parts.charts.clear();
    const auto lesson = folder.read(whole);
    CHECK_THAT(lesson.body, Contains("<td>GOOD</td>"));
    CHECK_THAT(lesson.body, Contains("<code>./raylab chart q1</code>"));
}

TEST_CASE("a lesson and a program that do not fit together are refused by file and line") {
    Folder folder;
    CHECK_THROWS_WITH(folder.read(whole + "\n![b](pictures/b.png)\n"), Contains("README.md:32"));
    CHECK_THROWS_WITH(folder.read(whole + "\n<!-- table: other -->\n| a |\n|---|\n"), Contains("other"));
    CHECK_THROWS_WITH(folder.read(whole + "\n<!-- nonsense -->\n"), Contains("nonsense"));
    CHECK_THROWS_WITH(folder.read(whole + "\n[x](missing.cpp)\n"), Contains("missing.cpp"));
    CHECK_THROWS_WITH(folder.read(whole + "\n<!-- table: numbers -->\n\ntext\n"), Contains("a table below"));
    CHECK_THROWS_WITH(folder.read("# 99 Demo\n\n![a](pictures/a.png)\n"), Contains("none for numbers"));
    CHECK_THROWS_WITH(folder.read(whole + "\n![a](pictures/a.png)\n"), Contains("a twice"));
}

TEST_CASE("links lead to chapters in the book, to copies of sources, and alone to no other page") {
    const auto chapters = source_folder() / "chapters";
    const auto lesson = chapters / "07_recursion/README.md";
    const auto in_book = ChapterRun::Place::in_book, alone = ChapterRun::Place::alone;
    LessonLinks links(lesson, in_book);
    CHECK(links.target("../05_lighting/README.md#phong") == "../05_lighting/index.html#phong");
    CHECK(links.target("../README.md") == "../index.html");
    CHECK(links.target("https://example.org/") == "https://example.org/");
    CHECK(links.target("scene.toml") == "source/scene.toml.txt");
    CHECK(links.file("source/scene.toml.txt") == chapters / "07_recursion/scene.toml");
    CHECK(links.sources().size() == 1);
    CHECK(LessonLinks(lesson, alone).target("../05_lighting/README.md").empty());
}

TEST_CASE("a link with a title shows the lines of the source, or the exercise") {
    const Folder folder;
    write_file(folder.path / "code.cpp", "int a() {\n    return 1 < 2;\n}\n");
    const auto lesson = folder.read(whole + "\n[the code](code.cpp \"int a(\")\n");
    CHECK_THAT(lesson.body, Contains("<figure class=\"excerpt\"><pre><code>int a() {\n    return 1 &lt; 2;\n}\n"));
    CHECK_THAT(lesson.body, Contains("lines 1 to 3"));
    CHECK(lesson.sources == std::vector<fs::path>{folder.path / "code.cpp"});
}
