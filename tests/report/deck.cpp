#include "raylab/report/page/deck.h"

#include "catch.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/page/page_parts.h"

#include <unistd.h>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_deck_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

std::string deck_of(const std::string& body) {
    const Folder folder;
    write_file(folder.path / "a.png", "\x89PNG");
    write_file(folder.path / "b.svg", "<svg/>");
    write_file(folder.path / "index.html",
               whole_page({.title = "A page", .kind = "lesson"},
                          "<nav class=\"book\"><a href=\"../index.html\">Book</a></nav>", body));
    return deck_from_page(folder.path / "index.html");
}

}  // namespace

TEST_CASE("a deck has its pictures in it and opens as a lecture") {
    const auto deck =
        deck_of("<figure data-trees=\"trees.js\"><a href=\"a.png\" data-values=\"a_values.js\"><img src=\"a.png\" "
                "loading=\"lazy\"></a></figure><img src=\"b.svg\">");
    CHECK_THAT(deck, Catch::Contains("<body data-deck class=\"lesson\""));
    CHECK_THAT(deck, Catch::Contains("<figure><img src=\"data:image/png;base64,iVBORw==\" loading=\"lazy\"></figure>"));
    CHECK_THAT(deck, Catch::Contains("<img src=\"data:image/svg+xml;base64,PHN2Zy8+\">"));
}

TEST_CASE("a deck links to nothing beside it, and keeps the words of such links") {
    const auto deck =
        deck_of("<p><a href=\"source/a.cpp.txt\">the <code>code</code></a>, <a href=\"#fig-a\">a figure</a>, <a "
                "href=\"https://example.org\">the web</a><a class=\"floats\" href=\"a.exr\">as floats</a>.</p>");
    CHECK_THAT(deck, Catch::Contains("<p>the <code>code</code>, <a href=\"#fig-a\">a figure</a>, <a "
                                     "href=\"https://example.org\">the web</a>.</p>"));
    CHECK_THAT(deck, !Catch::Contains("../index.html"));
}

TEST_CASE("a deck names the picture that is missing") {
    CHECK_THROWS_WITH(deck_of("<img src=\"gone.png\">"), Catch::Contains("gone.png"));
}
