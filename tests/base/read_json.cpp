#include "raylab/base/read_json.h"

#include "catch.h"

#include "raylab/base/error.h"

#include <nlohmann/json.hpp>

#include <string>

using namespace raylab;
using Catch::Contains;

namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

}  // namespace

TEST_CASE("JSON is read with its keys in the order of the text") {
    const auto json = json_from_text(R"({"b": [1, 2.5, null], "a": "x"})", "a.json");
    CHECK(json.dump() == R"({"b":[1,2.5,null],"a":"x"})");
}

TEST_CASE("JSON nested too deep is refused where it becomes so, whether its brackets match or not") {
    CHECK_NOTHROW(json_from_text(nested(deepest_json), "a.json"));
    for (const std::string& text : {nested(deepest_json + 1), nested(100'000), std::string(200'000, '[')})
        CHECK_THROWS_WITH(json_from_text(text, "a.json"),
                          "a.json:1 byte 64: expected arrays and objects nested at most 64 deep, found more");
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":\n";
    CHECK_THROWS_WITH(json_from_text(objects, "a.json"), Contains("a.json:65 byte 384: expected arrays and objects"));
}

TEST_CASE("brackets in strings nest nothing, after escaped quotes neither") {
    const std::string text = R"(["\"[[", "\\", ")" + std::string(1000, '[') + R"("])";
    CHECK(json_from_text(text, "a.json").at(2) == std::string(1000, '['));
}

TEST_CASE("what is no JSON is refused with its place, on one short line") {
    for (const std::string& text :
         {std::string(), std::string("{"), std::string("\n[1,\n]"), std::string("[\"\xff\"]"), std::string("[1e999]"),
          "[\"" + std::string(100'000, 'a'), std::string("[1] 2"), std::string("\0", 1)}) {
        try {
            json_from_text(text, "a.json");
            FAIL("taken: " << text);
        } catch (const Error& error) {
            const std::string said = error.what();
            INFO(said);
            CHECK(said.starts_with("a.json"));
            CHECK(said.find("expected JSON") != said.npos);
            CHECK(said.size() < 250);
        }
    }
    CHECK_THROWS_WITH(json_from_text("\n[1,\n]", "a.json"), Contains("a.json:3 byte 6: expected JSON"));
}
