#include "accelerator/shadow_rays.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/accelerator/light_buffer/light_buffered.h"
#include "raylab/accelerator/painters/painters_tree.h"
#include "raylab/accelerator/ray_space/ray_space.h"
#include "raylab/scene/moving.h"

// What stands before or beside a structure, in scenes in which things move: rays of all times are answered as the list
// does. (The structures themselves are asked in tests/experiment/structure_difference.cpp.)

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Scene any_moving_scene(Draw& draw) {
    const auto& kinds = moving_scene_kinds();
    return kinds[static_cast<std::size_t>(draw.integer(0, 2))].make(draw);  // all but those of any size
}

Ray at_any_time(Draw& draw, const Scene& scene, Ray ray) {
    ray.time = any_time(draw, ray_times(scene));
    return ray;
}

std::optional<std::string> compare_light_buffers(Draw& draw) {
    Scene scene = any_moving_scene(draw);
    for (int i = 0; i < 3; ++i) scene.lights.push_back({.kind = PointLight{any_light(draw, scene, 3)}});
    const auto list = make_accelerator("list", scene);
    const LightBuffered buffered(make_accelerator("bvh8", scene), scene, {.resolution = 8});
    Traversal remembering;
    for (int i = 0; i < 100; ++i) {
        const auto light = static_cast<std::size_t>(draw.integer(0, 2));
        const Vec3d& place = std::get<PointLight>(scene.lights[light].kind).position;
        const Ray ray = at_any_time(draw, scene, shadow_ray_to(place, convert<double>(draw.in_cube(5))));
        remembering.toward(light);
        Traversal alone;
        if (buffered.occluded(ray, remembering) != list->occluded(ray, alone)) return words(ray);
    }
    return std::nullopt;
}

std::optional<std::string> compare_item_buffer(Draw& draw) {
    const Scene scene = any_moving_scene(draw);
    const Camera camera{.position = convert<double>(draw.in_cube(8)), .target = {0.1, 0.2, 0.3}, .up = {0.1, 1, 0}};
    const CameraFrame frame = camera_frame(camera, {16, 12});
    const auto list = make_accelerator("list", scene);
    const ItemBuffer buffer(scene, frame, *list);
    Traversal traversal;
    for (int i = 0; i < 100; ++i) {
        const Ray ray = at_any_time(draw, scene, eye_ray(frame, draw.number(0, 16), draw.number(0, 12)));
        if (!same(list->closest(ray, traversal), buffer.closest(ray, traversal))) return words(ray);
    }
    return std::nullopt;
}

std::optional<std::string> compare_ray_space(Draw& draw) {
    const Scene scene = any_moving_scene(draw);
    std::vector<Ray> rays;
    for (int i = 0; i < 100; ++i)
        rays.push_back(at_any_time(draw, scene, through(any_point(draw), convert<double>(draw.in_cube(3)))));
    const auto list = make_accelerator("list", scene);
    const RaySpace space(scene, std::span(rays).first(50), *list, {.few_items = 1, .few_rays = 1});
    Traversal traversal;
    for (const Ray& ray : rays)
        if (!same(list->closest(ray, traversal), space.closest(ray, traversal))) return words(ray);
    return std::nullopt;
}

}  // namespace

TEST_CASE("light buffers let nothing through that moves, and stop nothing by it") {
    CHECK(faults(300, compare_light_buffers) == "");
}

TEST_CASE("an item buffer shows what moves at every time") { CHECK(faults(300, compare_item_buffer) == ""); }

TEST_CASE("ray space finds what moves at every time") { CHECK(faults(200, compare_ray_space) == ""); }

TEST_CASE("the painter refuses what moves while rays pass") {
    Scene scene{.objects = {object(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}};
    scene.source = "fly.toml";
    scene.objects[0].path = "triangle 0";
    scene.objects[0].motion = Motion{.translation = {1, 0, 0}};
    CHECK_NOTHROW(PaintersTree(scene));  // there is no shutter
    scene.camera.shutter = Shutter{0, 1};
    CHECK_THROWS_WITH(PaintersTree(scene),
                      "fly.toml: expected triangles that stand where they were made, found triangle 0");
}
