#include "catch.h"
#include "needs_scenes.h"

#include "raylab/scene/needs.h"

#include <nlohmann/json.hpp>

// Tests of which light paths a scene has, which of them Whitted's method misses, and of the answer as JSON and in
// words.

using namespace raylab;
using namespace pieces;

namespace {

// Every path from L to E over at most `most` surfaces of the given kinds.
std::vector<std::string> paths_over(const std::string& kinds, std::size_t largest) {
    std::vector<std::string> middles{""}, all;
    for (std::size_t i = 0; i < middles.size(); ++i) {
        if (!middles[i].empty()) all.push_back("L" + middles[i] + "E");
        if (middles[i].size() == largest) continue;
        for (const char kind : kinds) middles.push_back(middles[i] + kind);
    }
    return all;
}

}  // namespace

TEST_CASE("where surfaces are diffuse and specular, what is modelled and what is missed are all paths, each once") {
    const auto needs =
        needs_of(scene_of("[material.m]\nspecular = [1, 1, 1]\nkr = 0.5\n" + light + sphere("m") + floor("m")));
    for (const auto& path : paths_over("DS", 8)) {
        INFO(path);
        const bool modelled = matches(needs.paths, path) > 0;
        CHECK(modelled == (matches(needs.missed_paths, path) == 0));
    }
}

TEST_CASE("in a diffuse scene only interreflection is missed") {
    const auto needs = needs_of(scene_of(red + light + sphere("red") + floor("red")));
    CHECK(needs.paths.size() == 1);
    CHECK(needs.paths[0].expression == "LDE");
    for (const auto& path : paths_over("D", 6))
        CHECK(matches(needs.paths, path) + matches(needs.missed_paths, path) == 1);
}

TEST_CASE("a convex body that is alone has no path over two surfaces") {
    const auto needs = needs_of(scene_of(red + light + sphere("red")));
    CHECK(needs.paths.size() == 1);
    CHECK(needs.missed_paths.empty());
    CHECK_FALSE(mentions(needs.missed, "soft shadows"));
    const auto hollow = needs_of(scene_of("[camera]\nposition = [0, 0, 0.5]\n" + red + light + sphere("red")));
    CHECK(hollow.missed_paths.size() == 1);
}

TEST_CASE("emission is seen itself and in mirrors, and lights nothing") {
    const auto needs = needs_of(scene_of("[material.lava]\ndiffuse = [0, 0, 0]\nemission = [1, 0, 0]\n" + mirror +
                                         sphere("lava") + floor("mirror")));
    CHECK(matches(needs.paths, "LE") == 1);
    CHECK(matches(needs.paths, "LSE") == 1);
    CHECK(matches(needs.paths, "LDE") == 0);
    CHECK(mentions(needs.missed, "light of emitting surfaces"));
}

TEST_CASE("shadows of glass are a thing missed where there are both") {
    const std::string both = red + glass + sphere("glass") + floor("red");
    CHECK(mentions(needs_of(scene_of(both + light)).missed, "shadows of glass"));
    CHECK_FALSE(mentions(needs_of(scene_of(both)).missed, "shadows of glass"));
    CHECK_FALSE(mentions(needs_of(scene_of(red + light + sphere("red") + floor("red"))).missed, "shadows of glass"));
}

TEST_CASE("of up to four lights all are named, of more the rest is counted") {
    std::string lights = light + light + light + light;
    const auto shaded_by = [](const std::string& toml) {
        const auto asked = needs_of(scene_of(toml)).asked;
        return std::ranges::find(asked, "shadow rays", &Note::what)->why;
    };
    const std::string four = "light 0 (point), light 1 (point), light 2 (point), light 3 (point)";
    CHECK(shaded_by(lights + red + sphere("red") + floor("red")).starts_with(four + ": "));
    CHECK(shaded_by(lights + light + red + sphere("red") + floor("red")).starts_with(four + " and 1 more: "));
}

TEST_CASE("the same in JSON and in words") {
    const auto scene = scene_of("[material.m]\nkr = 0.5\n" + light + sphere("m") + floor("m"));
    const auto needs = needs_of(scene);
    const auto json = to_json(needs, scene);
    CHECK(json["depth"] == 8);
    CHECK(json["shadows"] == true);
    CHECK(json["lights"].size() == 1);
    CHECK(json["paths"][0]["expression"] == "LDE");
    const auto text = to_text(needs, scene);
    CHECK_THAT(text, Catch::Contains("LDS{1,7}E") && Catch::Contains("light 0 (point)") && Catch::Contains("LS+DS*E"));
}
