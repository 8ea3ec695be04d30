#include "raylab/accelerator/light_buffer/light_buffered.h"

#include "accelerator/shadow_rays.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/experiment/generate/loose_triangles.h"

using namespace raylab;
using namespace raylab::adversarial;

TEST_CASE("a structure with light buffers answers as the list does, whatever it is asked after what") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Draw draw(seed);
        Scene scene = any_scene(draw, draw.integer(0, 12));
        for (int i = 0; i < 3; ++i) scene.lights.push_back({.kind = PointLight{any_light(draw, scene, 3)}});
        scene.lights.push_back({.kind = DistantLight{{0, -1, 0}}});
        scene.lights.push_back({.kind = SpotLight{any_light(draw, scene, 3), {0, 0, 0}}});
        const auto list = make_accelerator("list", scene);
        const LightBuffered buffered(make_accelerator("bvh", scene), scene, {.resolution = 8});
        Traversal remembering, nothing;
        for (int i = 0; i < 300; ++i) {
            const auto light = static_cast<std::size_t>(draw.integer(0, 4));
            const auto* point = std::get_if<PointLight>(&scene.lights[light].kind);
            const Vec3d from = convert<double>(draw.in_cube(draw.one_in(9) ? 500 : 5));
            const Ray ray = point && !draw.one_in(5) ? shadow_ray_to(point->position, from)
                                                     : Ray{convert<float>(from), draw.lattice_direction(1), {0, 4}};
            remembering.toward(light);
            Traversal alone;
            const bool truth = list->occluded(ray, alone);
            INFO("seed " << seed << ", light " << light << ": " << adversarial::words(ray));
            CHECK(buffered.occluded(ray, remembering) == truth);
            CHECK(buffered.occluded(ray, nothing) == truth);
            CHECK(buffered.closest(ray, remembering).has_value() == truth);
        }
    }
}

TEST_CASE("a light buffer is the same for any number of threads that make it", "[threads]") {
    Draw draw(7);
    Scene scene = any_scene(draw, 300);
    scene.objects.push_back(object(mesh_of(soup(draw, 300, 3))));
    const Primitives primitives(scene);
    for (const Listing listing : {Listing::conservative, Listing::rectangles, Listing::centers}) {
        const auto lists = [&](int threads) {
            return light_lists(primitives, {0.3, 4, 0.1}, {.resolution = 32, .listing = listing, .threads = threads});
        };
        const LightLists one = lists(1);
        REQUIRE(one.entries.size() > 1000);
        REQUIRE(!one.everywhere.empty());
        for (const int threads : {2, 7}) {
            const LightLists several = lists(threads);
            CHECK(several.first == one.first);
            CHECK(several.entries == one.entries);
            CHECK(several.covers == one.covers);
            CHECK(several.everywhere == one.everywhere);
        }
    }
}

TEST_CASE("a light buffer whose lists are too long is not kept") {
    Draw draw(1);
    Scene scene = scene_of(soup(draw, 100, 2));
    scene.lights = {
        {.kind = PointLight{{0, 0, 0}}}, {.kind = PointLight{{1.1e3, 2e3, 0.9e3}}}, {.kind = DistantLight{{0, -1, 0}}}};
    const auto kept = [&](double longest) {
        return LightBuffered(make_accelerator("list", scene), scene, {.resolution = 16}, longest).buffers();
    };
    CHECK(kept(1e9) == 2);
    CHECK(kept(50) == 1);
    CHECK(kept(0.5) == 0);
}
