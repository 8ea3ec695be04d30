#include "catch.h"
#include "needs_scenes.h"

#include "raylab/scene/needs.h"

// Tests of the recursion, the materials and the viewer; shadows are in needs_shadows.cpp, light paths in
// needs_paths.cpp.

using namespace raylab;
using namespace pieces;

namespace {

int depth(const std::string& toml, NeedsOptions options = {}) { return needs_of(scene_of(toml), options).depth; }

}  // namespace

TEST_CASE("the depth is the smallest d with k^d no more than the threshold") {
    const std::string mirrors = mirror + light + floor("mirror") + sphere("mirror");
    const std::string two = light + red + floor("red");
    CHECK(depth(mirrors) == 8);  // 0.5^8 = 1/256
    CHECK(depth(mirrors, {.threshold = 0.3}) == 2);
    CHECK(depth(mirrors, {.threshold = 0.49}) == 2);
    CHECK(depth(mirrors, {.threshold = 0.5}) == 1);
    CHECK(depth(two + sphere("red")) == 1);
}

TEST_CASE("total internal reflection passes on kr + kt, unless nothing is bent") {
    const std::string two = light + red + floor("red");
    CHECK(depth(glass + two + sphere("glass"), {.threshold = 0.5}) == 3);  // 0.75, 0.5625, 0.4219
    const std::string air = "[material.glass]\nkr = 0.25\nkt = 0.5\nior = 1\n";
    CHECK(depth(air + two + sphere("glass"), {.threshold = 0.4}) == 2);
    CHECK(depth(air + two + sphere("glass"), {.threshold = 0.4, .split = NeedsOptions::Split::by_angle}) == 4);
    const std::string bubble = "[material.water]\nkt = 0.1\nior = 1.33\n" + air;  // it has total internal reflection
    CHECK(depth(bubble + two + sphere("glass") + sphere("water"), {.threshold = 0.5}) == 3);
}

TEST_CASE("where nothing is lost the limit of depth ends the recursion, and that is said") {
    const std::string toml = "[material.perfect]\nkr = 1\n" + light + sphere("perfect") + floor("perfect");
    const auto needs = needs_of(scene_of(toml), {.depth_limit = 7});
    CHECK(needs.depth == 7);
    CHECK(needs.passed_on.stopped_by_limit);
    CHECK(matches(needs.missed_paths, "LD" + std::string(7, 'S') + "E") == 1);
    CHECK(matches(needs.paths, "LD" + std::string(6, 'S') + "E") == 1);
    CHECK_FALSE(needs_of(scene_of(mirror + light + floor("mirror") + sphere("mirror"))).passed_on.stopped_by_limit);
}

TEST_CASE("the reason for a depth names the power of the coefficient that decided it") {
    const auto why = [](NeedsOptions options) {
        return needs_of(scene_of(mirror + light + floor("mirror") + sphere("mirror")), options).passed_on.why;
    };
    CHECK(why({.threshold = 0.3}).ends_with("k^2 is the first that is at most 0.3"));
    CHECK(why({.threshold = 0.1, .depth_limit = 3})
              .ends_with("k^3 is more than 0.1, so the limit of depth ends it (k^4 would not be)"));
    CHECK(why({.depth_limit = 7}).ends_with("(k^8 would not be)"));  // 0.5^8 = 1/256 is the threshold itself
}

TEST_CASE("a mirror that nobody sees, and one under the threshold, asks for no recursion") {
    CHECK(depth(mirror + red + light + sphere("red") + floor("red")) == 1);
    CHECK(depth("[material.faint]\nkr = 0.003\n" + red + light + sphere("faint") + floor("red")) == 1);
    const auto pair = [](const std::string& front, const std::string& back) {
        return "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = { front = \"" + front +
               "\", back = \"" + back + "\" }\n";
    };
    CHECK(depth(mirror + red + light + floor("red") + pair("red", "mirror")) == 1);
    CHECK(depth(mirror + red + light + floor("red") + pair("mirror", "red")) > 1);
    CHECK(depth("[camera]\nposition = [0, 0, 0.5]\n" + mirror + red + light + floor("red") + pair("red", "mirror")) >
          1);
}

TEST_CASE("a convex mirror that is alone shows the background, and a black one needs no ray") {
    CHECK(depth("[background]\ncolor = [0, 0, 1]\n" + mirror + sphere("mirror")) == 2);
    CHECK(depth("[background]\nzenith = [0, 0, 1]\n" + mirror + sphere("mirror")) == 2);
    CHECK(depth(mirror + sphere("mirror")) == 1);
    CHECK(depth("[background]\ncolor = [0, 0, 1]\n" + glass + sphere("glass")) > 2);
    CHECK(depth("[background]\ncolor = [0, 0, 1]\n" + glass + floor("glass")) == 2);
}

TEST_CASE("a single convex mirror shows the others, but never itself") {
    const std::string bright = "[material.perfect]\ndiffuse = [0, 0, 0]\nkr = 1\n" + red + light;
    const auto needs = needs_of(scene_of(bright + sphere("perfect") + floor("red")));
    CHECK(needs.depth == 2);
    CHECK_FALSE(needs.passed_on.stopped_by_limit);
    CHECK(matches(needs.paths, "LDSE") == 1);
    CHECK(matches(needs.paths, "LDSSE") == 0);
    CHECK(depth(bright + sphere("red") + floor("perfect")) == 2);
    CHECK(depth(bright + sphere("perfect") + floor("perfect")) > 2);
    CHECK(depth(bright + sphere("perfect") + sphere("perfect") + floor("red")) > 2);
    CHECK(depth("[camera]\nposition = [0, 0, 0.5]\n" + bright + sphere("perfect") + floor("red")) > 2);
    CHECK(needs_of(scene_of(bright + sphere("perfect") + floor("red")), {.depth_limit = 1}).passed_on.stopped_by_limit);
    CHECK_FALSE(
        needs_of(scene_of(bright + sphere("perfect") + floor("red")), {.depth_limit = 2}).passed_on.stopped_by_limit);
}

TEST_CASE("a mirror that is seen from inside passes light on as one that is seen from outside does") {
    const std::string room =
        "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = { front = \"red\", back = "
        "\"perfect\" }\n";
    const std::string perfect = "[camera]\nposition = [0, 0, 0.5]\n[material.perfect]\nkr = 1\n" + red + light;
    CHECK(depth(perfect + room + floor("perfect"), {.depth_limit = 9}) == 9);
}

TEST_CASE("mirrors ask for reflected rays, glass for both, unbent glass for no reflection of its own") {
    const std::string two = light + red + floor("red");
    const auto of = [&](const std::string& material) { return needs_of(scene_of(material + two + sphere("m"))); };
    const auto m = of("[material.m]\nkr = 0.5\n"), g = of("[material.m]\nkt = 0.5\nior = 1.5\n"),
               a = of("[material.m]\nkt = 0.5\n");
    CHECK((m.passed_on.reflection && !m.passed_on.transmission));
    CHECK((g.passed_on.reflection && g.passed_on.transmission));  // by total internal reflection
    CHECK((!a.passed_on.reflection && a.passed_on.transmission));
    CHECK(g.materials[0].refraction);
    CHECK_FALSE(a.materials[0].refraction);
    const auto coated = needs_of(scene_of("[material.m]\nkt = 0.5\nior = 1.5\n[material.back]\nkt = 0.5\n" + two +
                                          "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n"
                                          "material = { front = \"m\", back = \"back\" }\n"));
    CHECK(coated.materials[1].refraction);  // the front's index is that of the medium inside
}

TEST_CASE("a material asks for the terms that it has and the scene gives") {
    const std::string all = "[material.m]\nambient = [1, 1, 1]\nspecular = [1, 1, 1]\nemission = [1, 0, 0]\n"
                            "diffuse = { pattern = \"checker\", a = [1, 1, 1], b = [0, 0, 0], size = 1 }\n";
    const auto m =
        needs_of(scene_of("[background]\nambient = [0.1, 0.1, 0.1]\n" + all + light + floor("m"))).materials[0];
    CHECK((m.seen && m.ambient && m.diffuse && m.highlight && m.emission && m.checker));
    const auto dark = needs_of(scene_of(all + floor("m"))).materials[0];
    CHECK((dark.seen && !dark.ambient && !dark.diffuse && !dark.highlight && dark.emission && !dark.checker));
    const auto plain = needs_of(scene_of(red + light + floor("red"))).materials[0];
    CHECK((plain.diffuse && !plain.highlight && !plain.checker && !plain.emission && !plain.ambient));
}

TEST_CASE("a material that no object wears asks for nothing") {
    const auto needs = needs_of(scene_of(red + mirror + light + floor("red")));
    const auto unused = needs.materials.at(1);
    CHECK((!unused.seen && !unused.diffuse && !unused.reflection));
    CHECK(mentions(needs.left_out, "materials"));
}

TEST_CASE("a scene of nothing needs no ray") {
    const auto needs = needs_of(scene_of(light));
    CHECK_FALSE(needs.eye_rays);
    CHECK((!needs.shadows && !needs.recursion && needs.paths.empty() && needs.missed.empty()));
    CHECK(needs_of(scene_of(red + floor("red"))).eye_rays);
}

TEST_CASE("only a lens needs lens samples, and only what moves under an open shutter samples of time") {
    const std::string lens = "[camera]\nlens = { radius = 0.1, focus = 5 }\n", open = "[camera]\nshutter = [0, 1]\n";
    const std::string moving = sphere("red", "motion = [1, 0, 0]\n");
    CHECK(needs_of(scene_of(lens + red + sphere("red"))).lens);
    CHECK_FALSE(needs_of(scene_of(red + sphere("red"))).lens);
    CHECK(needs_of(scene_of(open + red + moving)).time);
    CHECK_FALSE(needs_of(scene_of(open + red + sphere("red"))).time);
    CHECK_FALSE(needs_of(scene_of(red + moving)).time);
    CHECK_FALSE(needs_of(scene_of(open + red + sphere("red", "motion = [0, 0, 0]\n"))).time);
    CHECK_FALSE(needs_of(scene_of("[camera]\nshutter = [1, 1]\n" + red + moving)).time);
    CHECK(mentions(needs_of(scene_of(open + red + moving)).missed, "motion blur"));
}

TEST_CASE("where most primitives move, so do the boxes") {
    const std::string open = "[camera]\nshutter = [0, 1]\n";
    const auto chosen = [&](int moving, int resting) {
        std::string toml = red;
        for (int i = 0; i < moving; ++i) toml += sphere("red", "motion = [1, 0, 0]\n");
        for (int i = 0; i < resting; ++i) toml += sphere("red");
        return std::pair{needs_of(scene_of(open + toml)).accelerator, needs_of(scene_of(toml)).accelerator};
    };
    CHECK(chosen(14, 13) == std::pair<std::string, std::string>{"bvh", "bvh8"});
    CHECK(chosen(13, 13) == std::pair<std::string, std::string>{"bvh8", "bvh8"});
    CHECK(chosen(9, 0) == std::pair<std::string, std::string>{"boxed_list", "boxed_list"});
}

TEST_CASE("two primitives need no boxes, twenty-four no tree, twenty-five do") {
    CHECK(needs_of(scene_of(red + sphere("red") + sphere("red"))).accelerator == "list");
    std::string toml = red;
    for (int i = 0; i < 24; ++i) toml += sphere("red");
    CHECK(needs_of(scene_of(toml)).accelerator == "boxed_list");
    CHECK(needs_of(scene_of(toml + sphere("red"))).accelerator == "bvh8");
}
