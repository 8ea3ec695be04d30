#include "catch.h"
#include "could_not.h"
#include "hostile/refusals.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Tests of `raylab needs` from outside.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const std::string scene = RAYLAB_SOURCE "/chapters/01_ray_generation/scene.toml";

ProcessResult needs(std::vector<std::string> words) {
    words.insert(words.begin(), "needs");
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

}  // namespace

TEST_CASE("raylab needs says in words what a scene needs") {
    const auto result = needs({scene});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    CHECK_THAT(result.output, Catch::Contains("LDE") && Catch::Contains("What must be modelled") &&
                                  Catch::Contains("What is left out") && Catch::Contains("shadow rays"));
    for (std::size_t from = 0; from < result.output.size();) {
        const auto end = result.output.find('\n', from);
        CHECK(end - from <= 120);
        from = end + 1;
    }
}

TEST_CASE("raylab needs --json - writes JSON and nothing else, --json FILE both") {
    const auto json = nlohmann::json::parse(needs({scene, "--json", "-"}).output);
    CHECK(json["shadows"] == true);
    CHECK(json["depth"] == 1);
    CHECK(json["renderer"] == "direct_light");  // it has shadow rays, but no mirror
    const fs::path file = fs::path(RAYLAB_BUILD) / "tests/needs/needs.json";
    fs::remove(file);
    const auto both = needs({scene, "--json", file.string()});
    CHECK(nlohmann::json::parse(read_file(file)) == json);
    CHECK_THAT(both.output, Catch::Contains("LDE"));
}

TEST_CASE("raylab needs says what radiosity would leave out, or why it cannot solve the scene") {
    const auto radiosity = [](const std::string& chapter) {
        return nlohmann::json::parse(
            needs({RAYLAB_SOURCE "/chapters/" + chapter + "/scene.toml", "--json", "-"}).output)["radiosity"];
    };
    CHECK(radiosity("14_radiosity") == nlohmann::json{{"can_solve", true}, {"not_shown", nlohmann::json::array()}});
    CHECK(radiosity("07_recursion")["not_shown"].size() > 3);
    CHECK_THAT(needs({RAYLAB_SOURCE "/chapters/07_recursion/scene.toml"}).output,
               Catch::Contains("radiosity would leave out:\n") && Catch::Contains("the mirror of material"));
}

TEST_CASE("raylab needs refuses a threshold that is none, and every broken scene, on one line") {
    const auto check_refused = [](const ProcessResult& result, const std::string& fragment) {
        check_could_not(result, fragment);
        CHECK(result.output.empty());
    };
    check_refused(needs({scene, "--threshold", "2"}), "expected a number from 0 to below 1 for --threshold, found 2");
    check_refused(needs({scene, "--threshold", "nan"}), "--threshold");
    check_refused(needs({scene, "--depth", "0"}), "--depth");
    for (const auto& [file, fragment] : refusals(RAYLAB_SOURCE "/tests/hostile/scenes"))
        check_refused(needs({file.string()}), fragment);
}
