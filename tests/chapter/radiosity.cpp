#include "catch.h"
#include "could_not.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

// Tests of `raylab radiosity` from outside: what it reuses, what it chooses, and which options it refuses together.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

ProcessResult radiosity(std::vector<std::string> words) {
    words.insert(words.begin(), {"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml"});
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

nlohmann::json told(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-"});
    const auto result = radiosity(words);
    INFO(result.errors);
    REQUIRE(result.succeeded());
    return nlohmann::json::parse(result.output);
}

void check_refused(const std::vector<std::string>& words, const std::string& fragment) {
    check_could_not(radiosity(words), fragment);
}

}  // namespace

TEST_CASE("raylab radiosity --cache says what it reused, in words and as JSON, and what it rebuilt") {
    const ScratchFolder folder;
    const std::vector<std::string> words{"--patches", "100", "--cache", folder.path().string()};
    const nlohmann::json nothing{{"form_factors", false}, {"solution", false}},
        all{{"form_factors", true}, {"solution", true}};
    CHECK(told(words)["reused"] == nothing);
    CHECK(told(words)["reused"] == all);
    for (const auto& file : fs::directory_iterator(folder.path())) fs::resize_file(file, fs::file_size(file) - 1);
    const auto again = radiosity(words);
    CHECK_THAT(again.output, Catch::Contains("reused: nothing") && Catch::Contains("rebuilt ") &&
                                 Catch::Contains("damaged or foreign"));
    CHECK_THAT(radiosity(words).output, Catch::Contains("reused: form factors and solution"));
}

TEST_CASE("raylab radiosity --mesh hierarchical --cache says which links it reused") {
    const ScratchFolder folder;
    const std::vector<std::string> words{"--mesh", "hierarchical", "--patches",
                                         "100",    "--cache",      folder.path().string()};
    CHECK_THAT(radiosity(words).output, Catch::Contains("reused: nothing; links and solution are kept"));
    CHECK(told(words)["reused"] == nlohmann::json{{"links", 0}, {"solution", true}});
    auto looser = words;
    looser.insert(looser.end(), {"--residual", "1e-3"});
    CHECK_THAT(radiosity(looser).output, Catch::Contains("links that were asked for"));
    CHECK_THAT(radiosity(looser).output, Catch::Contains("reused: links and solution"));
}

TEST_CASE("raylab radiosity says what memory it takes before it does, and refuses a matrix by naming what needs none") {
    CHECK(radiosity({"--patches", "100"}).errors.empty());  // less than a megabyte
    CHECK_THAT(radiosity({"--patches", "500"}).errors,
               Catch::StartsWith("memory: a matrix of form factors needs ") && Catch::Contains(" MiB: "));
    CHECK_THAT(radiosity({"--mesh", "hierarchical", "--edge", "0.01"}).errors,
               Catch::StartsWith("memory: hierarchical radiosity needs "));
    check_refused({"--patches", "100000", "--memory", "1G"}, "--mesh hierarchical needs no matrix");
    const auto linked = told({"--mesh", "hierarchical", "--patches", "100"});
    const double smallest = 24 * linked["links"].get<double>() + 100 * linked["elements"].get<double>();
    CHECK(linked["bytes"] > smallest);
    CHECK(linked["bytes"] < 10 * smallest);
}

TEST_CASE("raylab radiosity tells its picture's error, and --error what was tried to come within one") {
    CHECK(told({"--patches", "100"})["picture_error"]["relative"] > 0.1);
    const auto within = told({"--error", "0.24"});
    CHECK(within["picture_error"]["relative"] <= 0.24);
    CHECK(within["attempts"].size() >= 1);
    CHECK(within["attempts"].back()["error"] == within["picture_error"]["relative"]);
}

TEST_CASE("raylab radiosity refuses options that contradict each other") {
    check_refused({"--mesh", "hierarchical", "--ambient-estimate"}, "expected --ambient-estimate with --mesh uniform");
    check_refused({"--error", "0.1", "--edge", "0.1"}, "expected --edge without --error");
    check_refused({"--error", "0"}, "expected a number over 0 for --error");
    check_refused({"--tolerance", "0.1"}, "expected --tolerance with --mesh adaptive or hierarchical");
}

TEST_CASE("raylab radiosity --system refuses what only a scene has") {
    const ScratchFolder folder;
    const auto system = folder.path() / "system.json";
    write_file(system, R"({"area": [1], "emission": [[1, 1, 1]], "reflectance": [[0, 0, 0]], "F": [[0]]})");
    const auto solved = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"radiosity", "--system", system.string()});
        return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
    };
    CHECK(solved({}).output == "1 1 1\n");
    for (const std::string option : {"--output", "--table", "--vertices", "--gltf", "--walk"}) {
        check_could_not(solved({option, (folder.path() / "out.png").string()}),
                        "expected " + option + " with SCENE, found it with --system");
    }
}

TEST_CASE("raylab radiosity refuses a bad option of its outputs before it solves") {
    // Solving so many patches takes minutes.
    const auto refused = [](std::vector<std::string> words, const std::string& fragment) {
        const ScratchFolder folder;
        words.insert(words.end(), {"--patches", "20000", "-o", (folder.path() / "x.png").string()});
        check_refused(words, fragment);
    };
    refused({"--samples", "0"}, "expected --samples from 1 to 256, found 0");
    refused({"--show", "all"}, "expected --show to be one of gather, patches, vertices, found \"all\"");
    refused({"--exposure", "0"}, "expected a number over 0 for --exposure, found 0");
    refused({"--ambient-estimate"}, "expected --ambient-estimate with --solver shooting, found auto");
}
