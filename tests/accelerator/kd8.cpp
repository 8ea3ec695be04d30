#include "raylab/accelerator/kd8/kd8.h"
#include "catch.h"
#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <algorithm>
#include <tuple>
#include <vector>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Triangles that share corners, others, spheres among them, and a mesh that is placed.
Scene mixed() {
    Draw draw(8);
    Scene scene = scene_of(soup(draw, 500, 2));
    scene.objects.push_back(object(std::make_shared<const Mesh>(bumpy_sphere(3))));
    for (int i = 0; i < 60; ++i) scene.objects.push_back(object(Sphere{draw.in_cube(2), draw.uniform(0.05f, 0.2f)}));
    Affine aside;
    aside.translation = {2, 0, 0};
    scene.objects.push_back(object(std::make_shared<const Mesh>(bumpy_sphere(1)), aside));
    return scene;
}

// A cell in which something lies, and what.
using Leaf = std::tuple<std::vector<float>, std::vector<std::uint32_t>>;

std::vector<Leaf> leaves_of(const Outline& outline) {
    std::vector<Leaf> leaves;
    for (const Outline::Node& node : outline.nodes) {
        if (node.primitives.empty()) continue;
        const Box& box = std::get<Box>(node.bound);
        std::vector<std::uint32_t> primitives = node.primitives;
        std::ranges::sort(primitives);
        leaves.push_back({{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z}, primitives});
    }
    std::ranges::sort(leaves);
    return leaves;
}

}  // namespace

TEST_CASE("kd8 has the cells of the kd-tree, and in each the same primitives") {
    Draw draw(2);
    Scene scene = scene_of(soup(draw, 2'000, 2));
    for (int i = 0; i < 200; ++i) scene.objects.push_back(object(Sphere{draw.in_cube(2), draw.uniform(0.05f, 0.2f)}));
    for (const PlaneRule& rule : {surface_area_heuristic(Kd8::costs), object_median(3)}) {
        const auto expected = leaves_of(KdTree(scene, rule).outline());
        CHECK(expected.size() > 100);
        CHECK(leaves_of(Kd8(scene, rule).outline()) == expected);
    }
}

TEST_CASE("what a ray visits of kd8 is what closest() counts, and less than of the kd-tree") {
    const Scene scene{.objects = {object(std::make_shared<const Mesh>(bumpy_sphere(4)))}};
    const Kd8 tree(scene);
    const KdTree binary(scene);
    Traversal of_binary, of_tree;
    CHECK(faults(200, [&](Draw& draw) -> std::optional<std::string> {
              const Ray ray = through(draw.in_cube(3), convert<double>(draw.in_cube(1)));
              Traversal traversal;
              tree.closest(ray, traversal);
              tree.closest(ray, of_tree);
              binary.closest(ray, of_binary);
              std::size_t tests = 0, nodes = 0;
              for (const Visit& visit : tree.visits(ray)) {
                  tests += visit.tests;
                  nodes += visit.kind == Visit::Kind::inner;
              }
              if (tests == traversal.primitive_tests && nodes == traversal.steps) return std::nullopt;
              return "visits() and closest() went different ways";
          }) == "");
    CHECK(3 * of_tree.steps < of_binary.steps);
}

TEST_CASE("kd8 hits what the list hits where cells hold triangles, spheres and placed meshes") {
    const Scene scene = mixed();
    const Kd8 tree(scene);
    const auto list = make_accelerator("list", scene);
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        Ray ray{draw.in_cube(3), draw.in_cube(1)};
        if (draw.one_in(4)) ray.direction[draw.integer(0, 2)] = draw.one_in(2) ? 0.0f : -0.0f;
        if (draw.one_in(3)) ray.range = {draw.uniform(-1, 1), draw.uniform(0, 4)};
        Traversal traversal;
        const auto hit = list->closest(ray, traversal);
        const bool is_right =
            same(hit, tree.closest(ray, traversal)) && tree.occluded(ray, traversal) == hit.has_value();
        return is_right ? std::nullopt : std::optional(words(ray));
    };
    CHECK(faults(20'000, judge) == "");
}

TEST_CASE("kd8 takes fewer bytes than the kd-tree of one primitive after the other") {
    const Scene scene{.objects = {object(std::make_shared<const Mesh>(bumpy_sphere(5)))}};
    CHECK(Kd8(scene).bytes() < KdTree(scene).bytes());
}
