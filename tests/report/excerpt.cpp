#include "raylab/report/page/excerpt.h"

#include "catch.h"
#include "raylab/base/file.h"

#include <unistd.h>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

/// A source file for one test, which is removed with it.
struct Source {
    fs::path path = fs::temp_directory_path() / ("raylab_excerpt_" + std::to_string(::getpid()) + ".cpp");
    explicit Source(const std::string& text) { write_file(path, text); }
    ~Source() { fs::remove(path); }
};

}  // namespace

TEST_CASE("an excerpt is a function from its first line to its closing brace, without its indentation") {
    const Source source(
        "int a() {\n}\nclass B {\n    int c() {\n        if (x) {\n        }\n\n        return 1;\n    }\n    int d;\n};\n");
    const auto found = excerpt(source.path, "int c(");
    CHECK(found.text == "int c() {\n    if (x) {\n    }\n\n    return 1;\n}\n");
    CHECK(found.first_line == 4);
    CHECK(found.last_line == 9);
}

TEST_CASE("an excerpt that is not there, ambiguous, without an end or too long is refused by file and line") {
    std::string long_function = "void f() {\n";
    for (int i = 0; i < longest_excerpt; ++i) long_function += "    ;\n";
    const Source source("int twice;\nint twice;\nint open() {\n" + long_function + "}\n");
    CHECK_THROWS_WITH(excerpt(source.path, "missing"), Catch::Contains("exactly one line"));
    CHECK_THROWS_WITH(excerpt(source.path, "twice"), Catch::Contains("exactly one line"));
    CHECK_THROWS_WITH(excerpt(source.path, "void f("), Catch::Contains("at most 25 lines"));
    const Source endless("void f() {\n    ;\n");
    CHECK_THROWS_WITH(excerpt(endless.path, "void f("), Catch::Contains("closing brace"));
}
