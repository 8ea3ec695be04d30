#include "catch.h"
#include "could_not.h"

#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Tests of `raylab bench` from outside. The meshes are small, so that nothing about speed is tested.

using namespace raylab;

namespace {

ProcessResult bench(const std::vector<std::string>& words) {
    std::vector<std::string> all{"bench"};
    all.insert(all.end(), words.begin(), words.end());
    return run_process(std::filesystem::path(RAYLAB_BUILD) / "raylab", all, {.timeout = 600});
}

}  // namespace

TEST_CASE("raylab bench --json - gives a row a mesh, kind of rays, peer and number of threads, and nothing else") {
    const auto result = bench({"--meshes", "bumpy_2,knot_4", "--rays", "primary,shadow", "--peers", "list,bvh",
                               "--threads", "1,2", "--size", "16", "--repetitions", "1", "--json", "-"});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto rows = nlohmann::json::parse(result.output);
    REQUIRE(rows.size() == 2 * 2 * 2 * 2);
    for (const auto& row : rows) {
        INFO(row.dump());
        CHECK(row.at("wrong") == 0);
        CHECK(row.at("rays_per_second") > 0);
        CHECK(row.at("build_seconds") > 0);
        CHECK(row.at("bytes") > 0);
    }
    CHECK(rows.front().at("mesh") == "bumpy_2");
    CHECK(rows.front().at("rays") == "primary");
    CHECK(rows.front().at("peer") == "list");
    CHECK(rows.back().at("threads") == 2);
}

TEST_CASE("the foreign peers that are here answer, and are measured by their memory, too") {
    const auto result = bench({"--meshes", "bumpy_3", "--size", "32", "--repetitions", "1", "--json", "-"});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto rows = nlohmann::json::parse(result.output);
    REQUIRE(rows.size() >= 2 * 6);
    for (const auto& row : rows) {
        INFO(row.dump());
        CHECK(row.at("wrong") <= 2);  // of 1024; none of these rays is aimed at an edge
        CHECK(row.at("bytes") >= 20 * 1280);
        CHECK(row.at("bytes") <= 400 * 1280);
    }
}

TEST_CASE("raylab bench compares in a table") {
    const auto result = bench(
        {"--meshes", "bumpy_2", "--rays", "primary", "--peers", "bvh,list", "--size", "16", "--repetitions", "1"});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    CHECK_THAT(result.output, Catch::Contains("bumpy_2, 320 triangles") && Catch::Contains("bvh = 1"));
}

TEST_CASE("raylab bench refuses what it does not know, in one line") {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--meshes", "teacup"},
                                               {"--meshes", "bumpy_1", "--rays", "heat"},
                                               {"--meshes", "bumpy_1", "--peers", "wishful"},
                                               {"--threads", "none"},
                                               {"--clock", "sun"},
                                               {"--clock", "processor", "--threads", "2"},
                                               {"--size", "0"}}) {
        INFO(words.back());
        const auto result = bench(words);
        check_could_not(result, "expected");
        CHECK(result.output.empty());
    }
}
