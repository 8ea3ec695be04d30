#include "catch.h"

#include "raylab/base/process.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

// Compares the rays counted by `raylab render --spd` with the counts that V. Havran published for the Standard
// Procedural Databases (1999). They are reproduced with the offset of that tracer, and are the same for every
// accelerator and any number of threads.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Counts {
    double primary_hit, shadow, blocked, secondary, secondary_hit;

    friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counted(const fs::path& scene, const std::vector<std::string>& options) {
    std::vector<std::string> words{"render", scene.string(), "--spd", "--json", "-"};
    words.insert(words.end(), options.begin(), options.end());
    const auto result = run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 200});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto json = nlohmann::json::parse(result.output);
    const auto count = [&](const char* kind, const char* what) { return json.at(kind).at(what).get<double>(); };
    return {count("primary", "hit"), count("shadow", "cast"), count("shadow", "hit"), count("secondary", "cast"),
            count("secondary", "hit")};
}

// Spheres that touch and mirror each other, over a floor.
fs::path small_scene() {
    const fs::path file = fs::path(RAYLAB_BUILD) / "tests" / "touching.nff";
    std::ofstream out(file);
    out << "v\nfrom 0 -6 3\nat 0 0 0.5\nup 0 0 1\nangle 40\nhither 1\nresolution 96 96\nb 0.1 0.3 0.7\nl 4 -3 6\nl "
           "-5 -2 4\nf 1 0.8 0.4 1 0 0 0 0\np 4\n9 9 0\n-9 9 0\n-9 -9 0\n9 -9 0\nf 1 0.9 0.7 0.5 0.5 3 0 0\n";
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y) out << fmt::format("s {} {} 0.5 0.5\n", x, y);
    return file;
}

void check_within(double share, double counted, double published, const std::string& what) {
    INFO(fmt::format("{}: {} counted, {} published", what, counted, published));
    CHECK(std::abs(counted - published) <= share * published);
}

}  // namespace

TEST_CASE("every accelerator and any number of threads cast the same rays") {
    const auto scene = small_scene();
    const Counts one = counted(scene, {"--accelerator", "list", "--threads", "1"});
    CHECK(one.secondary_hit > 1000);
    CHECK(one == counted(scene, {"--accelerator", "bvh", "--threads", "1"}));
    CHECK(one == counted(scene, {"--accelerator", "bvh", "--threads", "2"}));
    CHECK_FALSE(one == counted(scene, {"--offset", "fixed:0.01"}));  // which is the subject of the next test
}

TEST_CASE("the counts published for the Standard Procedural Databases are reproduced with their offset") {
    const char* shared = std::getenv("RAYLAB_SHARED");
    if (!shared) {
        WARN("skipped: RAYLAB_SHARED names no folder with the databases");
        return;
    }
    struct Published {
        std::string scene;
        double share;
        Counts counts;
    };
    for (const auto& [scene, share, published] : {Published{"balls", 0.01, {263169, 959244, 285178, 179884, 134368}},
                                                  Published{"mount", 0.015, {173685, 361037, 74555, 710436, 472351}},
                                                  Published{"rings", 0.01, {263169, 1077336, 510719, 312879, 175688}},
                                                  Published{"tetra", 0.01, {49950, 46262, 5538, 0, 0}}}) {
        const Counts found = counted(fs::path(shared) / "spd" / (scene + ".nff"), {"--offset", "fixed:0.01"});
        check_within(share, found.primary_hit, published.primary_hit, scene + ", primary rays that hit");
        check_within(share, found.shadow, published.shadow, scene + ", shadow rays");
        check_within(share, found.blocked, published.blocked, scene + ", shadow rays blocked");
        check_within(share, found.secondary, published.secondary, scene + ", secondary rays");
        check_within(share, found.secondary_hit, published.secondary_hit, scene + ", secondary rays that hit");
    }
}
