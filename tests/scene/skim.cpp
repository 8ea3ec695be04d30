#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/scene/toml/skim.h"
#include "raylab/scene/toml/value.h"

#include <string>

using namespace raylab;

namespace {

bool passes(const std::string& text) {
    try {
        toml_file::check_outside_strings(text, "test.toml");
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

TEST_CASE("comments, strings of all four kinds and a byte order mark may hold any character") {
    CHECK(passes("\xef\xbb\xbf"
                 "a = 1 # \u00e4"));
    CHECK(passes("a = \"\u00e4\"\nb = '\u00e4'"));
    CHECK(passes("a = \"\\\"\u00e4\""));
    CHECK(passes("a = \"\"\"\n\u00e4 \"\" \u00e4\n\"\"\"\nb = '''\n\u00e4'\u00e4\n'''"));
    CHECK(passes("a = \"\"\"\u00e4\"\"\"\"\" # \"\n"));
}

TEST_CASE("characters beyond ASCII are refused wherever a string or a comment has ended") {
    CHECK_FALSE(passes("\u00e4 = 1"));
    CHECK_FALSE(passes("a = \"\" \u00e4"));
    CHECK_FALSE(passes("a = '\\' \u00e4"));
    CHECK_FALSE(passes("# comment\n\u00e4"));
    CHECK_FALSE(passes("a = \"\"\"\"\"\" \u00e4"));
    CHECK_FALSE(passes("a = \"\"\"x\"\"\"\"\" \u00e4"));
    CHECK_FALSE(passes("a = \"unfinished\n\u00e4"));
    CHECK_FALSE(passes("a = \"\"\"x\\\"\"\"\" \u00e4"));
    CHECK_FALSE(passes("a = 1 \xef\xbb\xbf"));
}

TEST_CASE("dots of numbers, of comments and of strings are not counted as dots of names") {
    std::string numbers = "a = [";
    for (int i = 0; i < 2000; ++i) numbers += "0.5, ";
    CHECK(passes(numbers + "]"));
    CHECK(passes("# " + std::string(2000, '.') + "\na = \"" + std::string(2000, '.') + "\""));
    CHECK_FALSE(passes("a" + std::string(33, '.') + " = 1"));
}

// toml++ alone declares the letter's place unreachable.
TEST_CASE("a letter beyond ASCII may follow a backslash that ends its line") {
    const auto root = toml_file::parse("title = \"\"\"a\\\n  \u00e4\"\"\"", "test.toml");
    CHECK(std::get<std::string>(std::get<toml_file::Value::Table>(root.data).front().value.data) == "a\u00e4");
}
