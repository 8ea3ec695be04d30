#include "catch.h"
#include "same_bits.h"
#include "tracer/random_scene.h"

#include "raylab/scene/needs.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/only_needed.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <array>

using namespace raylab;
using raylab::test::random_scene;

namespace {

const std::string head =
    "raylab = 1\n[image]\nwidth = 64\nheight = 48\n[background]\ncolor = [0.2, 0.3, 0.5]\nambient = [0.1, 0.1, 0.1]\n"
    "[material.red]\nambient = [1, 0, 0]\ndiffuse = [0.8, 0.1, 0.1]\nspecular = [0.4, 0.4, 0.4]\nshininess = 20\n"
    "[material.mirror]\ndiffuse = [0.1, 0.1, 0.1]\nkr = 0.5\n"
    "[material.glass]\ndiffuse = [0.1, 0.1, 0.1]\nkr = 0.1\nkt = 0.7\nior = 1.5\n"
    "[material.perfect]\ndiffuse = [0, 0, 0]\nkr = 1\n";
const std::string light = "[[light]]\ntype = \"point\"\nposition = [3, 6, 4]\n";

std::string sphere(const std::string& material, const std::string& center = "[0, 0, 0]") {
    return "[[shape]]\ntype = \"sphere\"\ncenter = " + center + "\nradius = 1\nmaterial = \"" + material + "\"\n";
}
const std::string ground = "[[shape]]\ntype = \"plane\"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = \"red\"\n";
const std::string capped_cone = "[[shape]]\ntype = \"cone\"\nbase = [0, -1, 0]\ntop = [0.3, 1, 0.2]\nbase_radius = 1\n"
                                "ends = \"capped\"\nmaterial = \"red\"\n";
const std::string shut_light = "[[light]]\ntype = \"point\"\nposition = [0, 0.5, 0]\n";

WhittedPicture picture(const Scene& scene, const WhittedOptions& options) {
    const auto accelerator = make_accelerator("auto", scene);
    return counted_whitted_picture(scene, *accelerator, camera_frame(scene.camera, scene.image), options,
                                   {.threads = 2});
}

}  // namespace

TEST_CASE("without what a scene does not need the picture is the same to the bit") {
    const std::string other_light = "[[light]]\ntype = \"distant\"\ndirection = [-1, -0.2, 0.3]\n";
    for (const auto& shapes :
         {std::string(), shut_light + sphere("red") + ground,
          light + sphere("perfect") + sphere("perfect", "[1, 2, 0]"), light + sphere("red"), light + capped_cone,
          light + ground, light + sphere("mirror"), light + sphere("glass"), other_light + light + capped_cone,
          light + sphere("red") + ground, light + sphere("mirror") + ground, sphere("glass") + ground,
          shut_light + sphere("red") + ground}) {
        const Scene scene = read_scene_text(head + shapes, "needs.toml");
        for (const WhittedOptions& asked : {WhittedOptions{}, WhittedOptions{.depth = 12, .threshold = 0.02},
                                            WhittedOptions{.reflectance = WhittedOptions::Reflectance::fresnel},
                                            WhittedOptions{.lit = WhittedOptions::Lit::outer_side}}) {
            const Scene reduced = with_lights(scene, seen_lights(scene, asked));
            const auto all = picture(scene, asked), needed = picture(reduced, only_needed(reduced, asked));
            INFO(shapes);
            CHECK(same_bits(all.image, needed.image));
            CHECK(same_bits(all.image, picture(scene, only_needed(scene, asked)).image));
            CHECK(needed.rays.shadow.cast <= all.rays.shadow.cast);
            CHECK(needed.rays.secondary.cast <= all.rays.secondary.cast);
        }
    }
}

TEST_CASE("in random scenes, too, what is left out changes no bit", "[threads]") {
    int shadow_rays_saved = 0, rays_saved = 0, lights_saved = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Scene scene = random_scene(seed);
        const WhittedOptions asked{.depth = 6, .threshold = seed % 3 == 0 ? 0.0 : 0.05};
        const Scene reduced = with_lights(scene, seen_lights(scene, asked));
        const auto all = picture(scene, asked), needed = picture(reduced, only_needed(reduced, asked));
        INFO("seed " << seed);
        CHECK(same_bits(all.image, needed.image));
        shadow_rays_saved += needed.rays.shadow.cast < all.rays.shadow.cast;
        rays_saved += needed.rays.secondary.cast < all.rays.secondary.cast;
        lights_saved += reduced.lights.size() < scene.lights.size();
    }
    CHECK((shadow_rays_saved > 10 && rays_saved > 0 && lights_saved > 10));
}

TEST_CASE("what is needed names the renderer that draws the picture") {
    std::array<int, 3> drawn{};
    const auto check = [&](const Scene& scene) {
        const WhittedOptions asked{.depth = 6, .threshold = 0.05};
        const Scene reduced = with_lights(scene, seen_lights(scene, asked));
        const Renderer renderer = cheapest_renderer(reduced, only_needed(reduced, asked));
        CHECK(needs_of(reduced, {.threshold = asked.threshold, .depth_limit = asked.depth}).renderer == renderer);
        ++drawn[static_cast<std::size_t>(renderer)];
    };
    for (std::uint64_t seed = 0; seed < 200; ++seed) check(random_scene(seed));
    const std::string red_only = head.substr(0, head.find("[material.mirror]"));
    for (const std::string& shape : {sphere("red"), capped_cone, sphere("red") + ground})
        check(read_scene_text(red_only + light + shape, "needs.toml"));
    for (const int count : drawn) CHECK(count > 0);
}

TEST_CASE("a sphere and a light take eye rays alone, a mirror and a floor all three kinds") {
    const Scene one = read_scene_text(head + light + sphere("red"), "needs.toml");
    const auto few = picture(one, only_needed(one, {})).rays;
    CHECK((few.primary.cast == 64 * 48 && few.shadow.cast == 0 && few.secondary.cast == 0));
    CHECK(picture(one, {}).rays.shadow.cast > 0);
    const Scene more = read_scene_text(head + light + sphere("mirror") + ground, "needs.toml");
    const auto many = picture(more, only_needed(more, {})).rays;
    CHECK((many.shadow.cast > 0 && many.secondary.cast > 0));
}

TEST_CASE("lights of which nothing is seen are left out, unless shadow rays are not to be trusted") {
    const Scene shut = read_scene_text(head + shut_light + light + sphere("red") + ground, "needs.toml");
    CHECK(with_lights(shut, seen_lights(shut, WhittedOptions{})).lights.size() == 1);
    CHECK(
        with_lights(shut, seen_lights(shut, WhittedOptions{.shadows = WhittedOptions::Shadows::none})).lights.size() ==
        2);
}

TEST_CASE("the depth that is never reached is never asked for") {
    const Scene scene =
        read_scene_text(head + light + sphere("mirror") + sphere("mirror", "[2, 0, 0]") + ground, "needs.toml");
    CHECK(only_needed(scene, {.depth = 100, .threshold = 0.2}).depth == 3);  // 0.5^2 = 0.25, 0.5^3 = 0.125
    CHECK(only_needed(scene, {.depth = 2, .threshold = 0.2}).depth == 2);
}

TEST_CASE("shadow rays that start carelessly keep the shadows they find") {
    const Scene scene = read_scene_text(head + light + sphere("red"), "needs.toml");
    WhittedOptions careless{};
    careless.start.offset = RayStart::Offset::none;
    CHECK(only_needed(scene, careless).shadows == WhittedOptions::Shadows::cast);
    WhittedOptions forgetful{};
    forgetful.start.leaving = RayStart::Leaving::forgotten;
    CHECK(only_needed(scene, forgetful).shadows == WhittedOptions::Shadows::cast);
    CHECK(only_needed(scene, {}).shadows == WhittedOptions::Shadows::none);
}
