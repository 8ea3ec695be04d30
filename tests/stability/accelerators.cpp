#include "catch.h"
#include "could_not.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Tests of `raylab stability accelerators` from outside. That it finds wrong structures is tested in tests/report.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path shared_edge = fs::path(RAYLAB_SOURCE) / "tests/stability/shared_edge.json";

ProcessResult accelerators(std::vector<std::string> words) {
    words.insert(words.begin(), {"stability", "accelerators"});
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 300});
}

}  // namespace

TEST_CASE("all structures are asked, nothing differs, and no file is written") {
    const fs::path out = fs::path(RAYLAB_BUILD) / "tests/differences";
    fs::remove_all(out);
    const auto result = accelerators({"--rays", "2000", "--json", "-", "--out", out});
    REQUIRE(result.code == 0);
    const auto json = nlohmann::json::parse(result.output);
    CHECK(json.at("rays") == 2000);
    CHECK(json.at("oracle_rays") > 0);
    std::uint64_t by_kind = 0;
    for (const auto& kind : json.at("scene_kinds")) by_kind += kind.at("rays").get<std::uint64_t>();
    CHECK(by_kind == 2000);
    CHECK(json.at("structures").size() == accelerator_names().size() - 2);  // all except the list itself and auto
    for (const auto& structure : json.at("structures")) CHECK(structure.at("wrong") == 0);
    CHECK_FALSE(fs::exists(out));
}

TEST_CASE("another seed asks other rays, the same seed the same") {
    const auto hits = [](const std::string& seed) {
        const auto result = accelerators({"--rays", "2000", "--json", "-", "--structure", "bvh", "--seed", seed});
        return nlohmann::json::parse(result.output).at("hits").get<int>();
    };
    CHECK(hits("1") == hits("1"));
    CHECK(hits("1") != hits("2"));
}

TEST_CASE("a case from a file is asked of the structure it names, or of another") {
    const auto result = accelerators({"--replay", shared_edge});
    CHECK(result.code == 0);
    CHECK(result.output == "bvh answers as expected: closest: part 0 of object 0 at t = 1 (0x1p+0)\n");
    for (const std::string& name : accelerator_names()) {
        INFO(name);
        CHECK(accelerators({"--replay", shared_edge, "--structure", name}).code == 0);
    }
}

TEST_CASE("a case whose shapes no scene may hold is refused on one line, exit 2") {
    const fs::path file = fs::path(RAYLAB_BUILD) / "tests/no_shape.json";
    const std::string good =
        R"({"raylab":"difference","structure":"bvh","scene":"b","rays_aimed":"c","expected":"d","found":"e",)"
        R"("rays":[{"origin":[0,0,5],"direction":[0,0,-1],"range":[0,9]}],"objects":[)";
    for (const std::string shape :
         {R"({"shape":"polygon","vertices":[]})", R"({"shape":"sphere","center":[0,0,0],"radius":"infinity"})"}) {
        write_file(file, good + shape + "]}");
        INFO(shape);
        check_could_not(accelerators({"--replay", file}), "expected");
    }
}

TEST_CASE("what cannot be asked is refused with exit 2") {
    CHECK(accelerators({"--structure", "wishful"}).code == 2);
    CHECK(accelerators({"--replay", "nowhere.json"}).code == 2);
    CHECK(accelerators({"--rays", "-1"}).code == 2);
}
