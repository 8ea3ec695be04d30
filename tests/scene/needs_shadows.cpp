#include "catch.h"
#include "needs_scenes.h"

#include "raylab/scene/needs.h"

// Tests of which lights shine, and which of them need shadow rays.

using namespace raylab;
using namespace pieces;

namespace {

LightNeeds first_light(const std::string& toml) { return needs_of(scene_of(toml)).lights.at(0); }

const std::string light_inside = "[[light]]\ntype = \"point\"\nposition = [0, 0.5, 0]\n";
const std::string eye_inside = "[camera]\nposition = [0, 0, 0.5]\n";

std::string open_cylinder(const std::string& ends) {
    return "[[shape]]\ntype = \"cylinder\"\nbase = [0, -1, 0]\ntop = [0, 1, 0]\nradius = 1\nends = \"" + ends +
           "\"\nmaterial = \"red\"\n";
}

}  // namespace

TEST_CASE("a convex body that is alone casts no shadow on what faces the light") {
    CHECK_FALSE(first_light(red + light + sphere("red")).shadow_rays);
    CHECK(first_light(red + light + sphere("red")).shines);
    CHECK_FALSE(first_light(red + light + open_cylinder("capped")).shadow_rays);
    CHECK_FALSE(
        first_light(red + "[[light]]\ntype = \"distant\"\ndirection = [0, -1, 0]\n" + sphere("red")).shadow_rays);
    CHECK_FALSE(needs_of(scene_of(red + light + sphere("red"))).shadows);
}

TEST_CASE("an open, hollowed or transparent body can shade itself") {
    CHECK(first_light(red + light + open_cylinder("open")).shadow_rays);
    CHECK(first_light(red + light +
                      "[[shape]]\ntype = \"hyperboloid\"\nbase = [0, -1, 0]\ntop = [0, 1, 0]\nwaist = 0.3\n" +
                      "radius = 1\nends = \"capped\"\nmaterial = \"red\"\n")
              .shadow_rays);
    CHECK(first_light("[material.glass]\nkt = 0.5\n" + light + sphere("glass")).shadow_rays);
}

TEST_CASE("from inside, a light outside is hidden and a light inside is not") {
    CHECK(first_light(eye_inside + red + light + sphere("red")).shadow_rays);
    CHECK_FALSE(first_light(eye_inside + red + light_inside + sphere("red")).shadow_rays);
    CHECK(first_light(eye_inside + red + light_inside + sphere("red")).shines);
}

TEST_CASE("one side of a sphere decides like a viewer that sees no other") {
    CHECK_FALSE(first_light(eye_inside + red + light + sphere("red", "sides = \"front\"\n")).shadow_rays);
    CHECK(first_light(red + light + sphere("red", "sides = \"back\"\n")).shadow_rays);
    CHECK_FALSE(first_light(red + light_inside + sphere("red", "sides = \"back\"\n")).shadow_rays);
}

TEST_CASE("a flat shape that is alone needs no shadow rays") {
    CHECK_FALSE(first_light(red + light + floor("red")).shadow_rays);
}

TEST_CASE("two objects can shade each other") {
    CHECK(first_light(red + light + sphere("red") + floor("red")).shadow_rays);
}

TEST_CASE("a viewer that may be anywhere near the sphere proves nothing") {
    const std::string beside = "[camera]\nposition = [0, 0, 1.5]\n";
    CHECK_FALSE(first_light(beside + red + light + sphere("red")).shadow_rays);
    CHECK(first_light(beside + "lens = { radius = 0.6, focus = 1 }\n" + red + light + sphere("red")).shadow_rays);
    CHECK(first_light(beside + "type = \"orthographic\"\nheight = 2\n" + red + light + sphere("red")).shadow_rays);
    CHECK(first_light(beside + "shutter = [0, 1]\n" + red + light + sphere("red", "motion = [0, 0, 2]\n")).shadow_rays);
    CHECK(
        first_light(beside + "shutter = [-1, 0]\n" + red + light + sphere("red", "motion = [0, 0, -2]\n")).shadow_rays);
}

TEST_CASE("of a parallel camera's picture every corner counts, however it is rolled") {
    const auto rolled_above =
        [](const std::string& height) {  // above the ball of radius 10; the corners are sqrt(2) lower
            return "[image]\nwidth = 64\nheight = 64\n[camera]\ntype = \"orthographic\"\nheight = 2\nup = [1, 1, 0]\n"
                   "position = [0, " +
                   height + ", 0]\ntarget = [0, " + height + ", -5]\n" + red +
                   "[[light]]\ntype = \"point\"\nposition = [0, 30, 0]\n"
                   "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 10\nmaterial = \"red\"\n";
        };
    CHECK(first_light(rolled_above("11.25")).shadow_rays);
    CHECK_FALSE(first_light(rolled_above("14")).shadow_rays);
}

TEST_CASE("an eye that its rays' floats may put on the surface proves nothing") {
    const std::string hardly_outside = "[camera]\nposition = [0, 0, 1.000000001]\n";
    CHECK(first_light(hardly_outside + red + light + sphere("red")).shadow_rays);
}

TEST_CASE("a light that may be on a body's surface may be shaded by it") {
    const std::string on_it = "[[light]]\ntype = \"point\"\nposition = [0, 1, 0]\n";
    CHECK(first_light(red + on_it + sphere("red")).shadow_rays);
}

TEST_CASE("a black light, and one that nothing answers to, asks for nothing") {
    const auto black = first_light(red + light + "color = [0, 0, 0]\n" + sphere("red") + floor("red"));
    CHECK_FALSE(black.shines);
    CHECK_FALSE(black.shadow_rays);
    CHECK(black.why == "it is black");
    CHECK_FALSE(first_light(mirror + light + sphere("mirror") + floor("mirror")).shines);
    CHECK(first_light(mirror + "specular = [0.1, 0, 0]\n" + light + sphere("mirror") + floor("mirror")).shines);
    CHECK_FALSE(first_light(red + light).shines);
}

TEST_CASE("a light shut in by an opaque body lights nothing that is seen, and that is worth a warning") {
    const auto needs = needs_of(scene_of(red + light + light_inside + sphere("red") + floor("red")));
    CHECK(needs.lights[0].shines);
    CHECK_FALSE(needs.lights[1].shines);
    REQUIRE(needs.warnings.size() == 1);
    CHECK(needs.warnings[0].what == "light 1 lies inside sphere 0");
}

TEST_CASE("a light shut in with a viewer who may be inside too is kept") {
    const std::string lens_across = "[camera]\nposition = [0, 0, 1.5]\nlens = { radius = 0.6, focus = 1 }\n";
    const auto needs = needs_of(scene_of(lens_across + red + light_inside + sphere("red") + floor("red")));
    CHECK(needs.lights[0].shines);
    CHECK(needs.warnings.empty());
}

TEST_CASE("a light inside glass shines there, and is worth a warning") {
    const auto needs = needs_of(scene_of("[material.glass]\nkt = 0.5\n" + light_inside + sphere("glass")));
    CHECK(needs.lights[0].shines);
    CHECK(needs.warnings.size() == 1);
}

TEST_CASE("a light inside a closed mesh is worth a warning, but is not left out") {
    const std::vector<Mesh::Face> outward{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
        inward{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const auto around = [&](const std::string& position, const std::vector<Mesh::Face>& faces) {
        auto scene = scene_of(red + "[[light]]\ntype = \"point\"\nposition = " + position + "\n");
        scene.objects.push_back(
            {.shape = std::make_shared<const Mesh>(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, faces}),
             .path = "mesh 0"});
        return needs_of(scene);
    };
    for (const auto& faces : {outward, inward}) {
        REQUIRE(around("[0.2, 0.2, 0.2]", faces).warnings.size() == 1);
        CHECK(around("[0.2, 0.2, 0.2]", faces).warnings[0].what == "light 0 lies inside mesh 0");
        CHECK(around("[0.2, 0.2, 0.2]", faces).lights[0].shines);
        CHECK(around("[0.9, 0.9, 0.9]", faces).warnings.empty());  // inside its box only
        CHECK(around("[3, 3, 3]", faces).warnings.empty());
    }
}

TEST_CASE("a lit room round the viewer is no mistake, nor is a body open to light from outside") {
    CHECK(needs_of(scene_of(eye_inside + red + light_inside + sphere("red"))).warnings.empty());
    const auto hollow = needs_of(scene_of(red + light_inside + sphere("red", "sides = \"back\"\n") + floor("red")));
    CHECK(hollow.warnings.empty());
    CHECK(hollow.lights[0].shines);
}

TEST_CASE("only lights that grow weaker with the distance ask for it, and only spots for a cone") {
    const std::string attenuation = "attenuation = [1, 0, 0.1]\n";
    CHECK_FALSE(first_light(red + light + sphere("red")).distance);
    CHECK(first_light(red + light + attenuation + sphere("red")).distance);
    CHECK_FALSE(first_light(red + "[[light]]\ntype = \"distant\"\ndirection = [0, -1, 0]\n" + sphere("red")).distance);
    CHECK_FALSE(first_light(red + light + sphere("red")).cone);
    CHECK(first_light(red + "[[light]]\ntype = \"spot\"\nposition = [0, 3, 0]\ntarget = [0, 0, 0]\n" + sphere("red"))
              .cone);
}
