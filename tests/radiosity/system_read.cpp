#include "raylab/radiosity/system/read_system.h"

#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

using namespace raylab;
using Catch::Contains;

namespace {

RadiositySystem read(const std::string& text, const MemoryLimit& limit = {}) {
    return system_from_json(json_from_text(text, "room.json", limit), "room.json", limit);
}

// Two plates, one field of which is written otherwise.
std::string plates(const std::string& field, const std::string& value) {
    nlohmann::ordered_json json{
        {"area", {1, 2}}, {"emission", {1, 0}}, {"reflectance", {0.5, 0.8}}, {"F", {{0, 1}, {0.5, 0}}}};
    std::string text = "{";
    json[field] = "VALUE";
    for (const auto& [name, entry] : json.items())
        text += "\"" + name + "\":" + (name == field ? value : entry.dump()) + ",";
    text.back() = '}';
    return text;
}

}  // namespace

TEST_CASE("a system is read from numbers, with one or three channels") {
    const RadiositySystem system = read(
        R"({"area": [1, 2], "emission": [1, [0, 0.5, 2]], "reflectance": [[0.1, 0.2, 0.3], 0.8], "F": [[0, 1], [0.5, 0]]})");
    CHECK(system.area == std::vector<double>{1, 2});
    CHECK(system.emission == std::vector<Color>{Color(1), Color(0, 0.5, 2)});
    CHECK(system.reflectance == std::vector<Color>{Color(0.1, 0.2, 0.3), Color(0.8)});
    CHECK(system.form_factors.at(0, 1) == 1);
    CHECK(system.form_factors.at(1, 0) == 0.5);
    CHECK(read(R"({"area": [], "emission": [], "reflectance": [], "F": []})").patches() == 0);
}

TEST_CASE("numbers that no system has are refused with their place") {
    struct Bad {
        const char *field, *value, *said;
    };
    for (const auto& [field, value, said] :
         {Bad{"area", "[1, 0]", "room.json /area/1: expected an area above 0, found 0"},
          {"area", "3", "room.json /area: expected an array of areas, found 3"},
          {"area", "[1]",
           "room.json /emission: expected an array of 1 patches, as many as \"area\" has, found an array of 2"},
          {"emission", "[1, -1]", "room.json /emission/1: expected an emission of at least 0, found -1"},
          {"emission", "[1, [0, 1]]",
           "room.json /emission/1: expected an array of 3 channels, or one number, found an array of 2"},
          {"reflectance", "[0.5, 1]", "room.json /reflectance/1: expected a reflectance from 0 to below 1, found 1"},
          {"reflectance", "[[0, 0, -0.1], 0]",
           "room.json /reflectance/0/2: expected a reflectance from 0 to below 1, found -0.1"},
          {"reflectance", "[0.5, \"grey\"]",
           "room.json /reflectance/1: expected a reflectance from 0 to below 1, found \"grey\""},
          {"F", "[[0, 1]]", "room.json /F: expected an array of 2 rows, as many as \"area\" has, found an array of 1"},
          {"F", "[[0, 1], [0.5]]", "room.json /F/1: expected an array of 2 form factors, found an array of 1"},
          {"F", "[[0, 1], [-0.5, 0]]", "room.json /F/1/0: expected a form factor of at least 0, found -0.5"},
          {"F", "[[0, 1], [null, 0]]", "room.json /F/1/0: expected a form factor of at least 0, found null"},
          {"F", "{}", "room.json /F: expected an array of 2 rows, as many as \"area\" has, found an object of 0"}})
        CHECK_THROWS_WITH(read(plates(field, value)), said);
    CHECK_THROWS_AS(read(plates("F", "[[0, 1e999], [0, 0]]")), Error);
}

TEST_CASE("missing and unknown fields are refused") {
    CHECK_THROWS_WITH(read(R"({"area": [1], "emission": [1], "F": [[0]]})"),
                      "room.json: expected a field \"reflectance\", found none");
    CHECK_THROWS_WITH(read(plates("emision", "[1, 0]")),
                      "room.json: expected only the fields area, emission, reflectance, F, found \"emision\" (did you "
                      "mean \"emission\"?)");
    CHECK_THROWS_WITH(read("[1]"),
                      "room.json: expected an object with the fields area, emission, reflectance, F, found array");
}

TEST_CASE("a matrix over the memory limit is refused before it is made") {
    std::string ones = "0.5";
    std::string rows = "[]";
    for (int i = 1; i < 2000; ++i) ones += ",0.5", rows += ",[]";
    const std::string text = R"({"area": [)" + ones + R"(], "emission": [)" + ones + R"(], "reflectance": [)" + ones +
                             R"(], "F": [)" + rows + "]}";
    CHECK_THROWS_WITH(read(text, {std::uint64_t{1} << 24}),
                      "room.json: expected at most 16.0 MiB (--memory), found a matrix of form factors that needs 30.5 "
                      "MiB: 2000 x 2000 doubles");
}
