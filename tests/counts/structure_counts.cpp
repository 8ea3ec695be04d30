#include "catch.h"

#include "raylab/base/process.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>

// Compares the cost of a ray in a structure with the counts that V. Havran published for the Standard Procedural
// Databases (1999): with the same rays there are at most as many tests and steps.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Cost {
    double tests, steps;
};

Cost cost_of(const fs::path& scene, const std::string& accelerator) {
    const auto result = run_process(
        fs::path(RAYLAB_BUILD) / "raylab",
        {"render", scene.string(), "--spd", "--offset", "fixed:0.01", "--accelerator", accelerator, "--json", "-"},
        {.timeout = 200});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto json = nlohmann::json::parse(result.output);
    double rays = 0;
    for (const char* kind : {"primary", "shadow", "secondary"}) rays += json.at(kind).at("cast").get<double>();
    return {json.at("primitive_tests").get<double>() / rays, json.at("steps").get<double>() / rays};
}

}  // namespace

TEST_CASE("a grid or an octree takes no more tests and no more steps than the published one") {
    const char* shared = std::getenv("RAYLAB_SHARED");
    if (!shared) {
        WARN("skipped: RAYLAB_SHARED names no folder with the databases");
        return;
    }
    struct Published {
        std::string scene, accelerator;
        Cost cost;
    };
    // Density 1 takes long.
    for (const auto& [scene, accelerator, published] :
         {Published{"balls", "grid:10", {72.54, 12.40}}, Published{"mount", "grid:1", {19.01, 8.85}},
          Published{"mount", "grid:10", {13.17, 18.43}}, Published{"rings", "grid:10", {23.36, 24.51}},
          Published{"tetra", "grid:1", {20.64, 7.43}}, Published{"tetra", "grid:10", {10.01, 15.97}},
          // At depth 5, too.
          Published{"balls", "octree:7", {94.75, 167.00}}, Published{"mount", "octree:5", {23.72, 30.89}},
          Published{"mount", "octree:7", {18.52, 60.08}}, Published{"tetra", "octree:5", {63.58, 32.08}},
          Published{"tetra", "octree:7", {47.07, 58.09}}}) {
        const Cost found = cost_of(fs::path(shared) / "spd" / (scene + ".nff"), accelerator);
        INFO(fmt::format("{}, {}: {:.2f} tests, {:.2f} steps", scene, accelerator, found.tests, found.steps));
        CHECK(found.tests <= published.tests);
        CHECK(found.steps <= published.steps);
    }
}
