#include "raylab/base/wrapped_text.h"

#include "catch.h"
#include "raylab/base/painted_signs.h"

using namespace raylab;

TEST_CASE("text is wrapped between words, by characters and not by bytes") {
    CHECK(wrapped("one two three", 7) == std::vector<std::string>{"one two", "three"});
    CHECK(wrapped("öööö öö", 7) == std::vector<std::string>{"öööö öö"});
    CHECK(wrapped("interminable a", 5) == std::vector<std::string>{"interminable", "a"});
    CHECK(wrapped("", 5) == std::vector<std::string>{""});
}

TEST_CASE("a sign is painted with its words, and the words are the same without paint") {
    CHECK(painted_signs("a  ✓ it holds  b\n") == "a  \033[32m✓ it holds\033[0m  b\n");
    CHECK(painted_signs("✗ fails\n‼ FAILS") == "\033[31m✗ fails\033[0m\n\033[1;97;41m‼ FAILS\033[0m");
    CHECK(painted_signs("plain  words\n") == "plain  words\n");
}
