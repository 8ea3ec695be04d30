#include "catch.h"

#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Tests of what `raylab chart` and `raylab stability --list` list.

using namespace raylab;

namespace {

std::string told(const std::vector<std::string>& words) {
    const auto result = run_process(std::filesystem::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    return result.output;
}

// The list in words, made of the one as JSON.
std::string in_lines(const std::string& json) {
    std::string lines;
    for (const auto& item : nlohmann::json::parse(json))
        lines += item.at("name").get<std::string>() + "  (chapter " + item.at("chapter").get<std::string>() + ")\n";
    return lines;
}

}  // namespace

TEST_CASE("--json writes the questions of raylab chart and the cases of raylab stability, as their lists say them") {
    CHECK(in_lines(told({"chart", "--json", "-"})) == told({"chart"}));
    CHECK(in_lines(told({"stability", "--list", "--json", "-"})) == told({"stability", "--list"}));
}
