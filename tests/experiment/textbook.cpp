#include "catch.h"
#include "tracer/glass.h"
#include "tracer/is_textbook.h"

#include "raylab/experiment/textbook/textbook.h"
#include "raylab/experiment/textbook/textbook_surface.h"
#include "raylab/report/ray_tree/ray_tree_difference.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"

#include <algorithm>

using namespace raylab;

namespace {

// One glass sphere only: transparent objects must not overlap.
Scene textbook_scene() {
    Scene scene = glass_scene();
    scene.objects.erase(scene.objects.begin() + 2);
    return scene;
}

// The textbook asks for the light behind a surface, too; who knows better sends no shadow ray there.
RayTree without_shadow_rays(const RayTree& tree) {
    RayTree result{.nodes = {}, .pixel = tree.pixel};
    std::vector<std::size_t> place(tree.nodes.size(), RayNode::none);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].kind == RayKind::shadow) continue;
        place[i] = result.nodes.size();
        result.nodes.push_back(tree.nodes[i]);
        if (i > 0) result.nodes.back().parent = place[tree.nodes[i].parent];
    }
    return result;
}

RayOf<double> same_ray(const Ray& ray) {
    return {convert<double>(ray.origin), convert<double>(ray.direction), {0, INFINITY}};
}

}  // namespace

TEST_CASE("the textbook's trees are Whitted's, but for rays that graze an edge") {
    const auto lights = textbook_scene().lights;
    for (const auto& light : lights) {
        Scene scene = textbook_scene();
        scene.lights = {light};
        REQUIRE(test::is_textbook(scene));
        const auto accelerator = make_accelerator("list", scene);
        const auto frame = camera_frame(scene.camera, scene.image);
        int differ = 0, rays = 0;
        std::string last;
        for (int y = 0; y < scene.image.height; ++y)
            for (int x = 0; x < scene.image.width; ++x) {
                const Ray ray = eye_ray(frame, x + 0.5, y + 0.5);
                const RayTree expected = without_shadow_rays(ray_tree(scene, *accelerator, {.depth = 4}, ray));
                const auto difference = first_difference(without_shadow_rays(textbook_tree(scene, same_ray(ray), 4)),
                                                         expected, {1e-4, 1e-4});
                ++rays;
                differ += difference.has_value();
                if (difference) last = to_string(*difference);
            }
        INFO(differ << " of " << rays << " differ, the last of them: " << last);
        CHECK(differ <= rays / 200);
    }
}

TEST_CASE("of two surfaces at one place the textbook sees the one that the scene has first") {
    const Scene scene{.objects = {{.shape = Sphere{{0, 0, 0}, 1}}, {.shape = Sphere{{0, 0, 0}, 1}}}};
    const auto seen = textbook_surface(scene, {{0, 0, 5}, {0, 0, -1}, {0, INFINITY}});
    REQUIRE(seen);
    CHECK(seen->object == &scene.objects[0]);
}

TEST_CASE("the contributions of a textbook's tree add up to its pixel") {
    const Scene scene = textbook_scene();
    const auto frame = camera_frame(scene.camera, scene.image);
    for (int x = 0; x < scene.image.width; ++x) {
        const RayTree tree = textbook_tree(scene, picture_ray(frame, x + 0.5, 30.5), 6);
        Color sum{0, 0, 0};
        for (const auto& node : tree.nodes)
            if (node.kind != RayKind::shadow) sum += node.contribution;
        CHECK(glm::length(sum - tree.pixel) < 1e-12);
    }
}
