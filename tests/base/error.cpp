#include "catch.h"

#include "raylab/base/error.h"

using namespace raylab;

TEST_CASE("an error names file, line, what was expected and what was found, on one line") {
    const Error error({"scene.toml", 14}, "kr + kt <= 1", "1.2\nand more");
    CHECK(error.what() == std::string("scene.toml:14: expected kr + kt <= 1, found 1.2\\u{a}and more"));
}

TEST_CASE("what an error quotes cannot steer a terminal") {
    CHECK(Error("found '\x1b[31m\u202e\xff'").what() == std::string("found '\\u{1b}[31m\\u{202e}\\xff'"));
}

TEST_CASE("a place inside a file follows its name") {
    CHECK(to_string({"rays.bin", 0, "record 17"}) == "rays.bin record 17");
    CHECK(to_string({"rays.bin"}) == "rays.bin");
}
