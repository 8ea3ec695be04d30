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

TEST_CASE("an object of more names than any file of the lab has is refused at the first too many") {
    const auto object = [](int names) {
        std::string text = "[{},{";
        for (int i = 0; i < names; ++i) text += (i > 0 ? ",\n\"a" : "\"a") + std::to_string(i) + "\":0";
        return text + "}]";
    };
    CHECK(json_from_text(object(256), "a.json").at(1).size() == 256);
    for (const int names : {257, 400'000})
        CHECK_THROWS_WITH(
            json_from_text(object(names), "a.json"),
            Contains("a.json:257 byte ") && Contains("expected at most 256 names in an object, found more"));
}

TEST_CASE("JSON that takes more than the limit when parsed is refused before") {
    const std::string text = "[" + std::string(100'000, ' ') + "[],[],[1,2]]";
    CHECK_NOTHROW(json_from_text(text, "a.json", {1 << 20}));
    std::string many = "[";
    for (int i = 0; i < 100'000; ++i) many += "[],";
    CHECK_THROWS_WITH(
        json_from_text(many + "0]", "a.json", {1 << 20}),
        "a.json: expected at most 1.0 MiB (--memory), found JSON that needs 11.0 MiB: 300003 bytes of it, "
        "parsed");
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
