#include "raylab/accelerator/bvh/bvh.h"
#include "catch.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <set>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

const std::vector<std::string> trees{"bvh_sphere", "bvh", "bvh_obb"};

Scene bumpy(int levels) {
    Scene scene;
    scene.objects.push_back(object(std::make_shared<Mesh>(bumpy_sphere(levels))));
    return scene;
}

Ray ray_at(Draw& draw) { return through(draw.in_cube(4), convert<double>(draw.in_cube(1))); }

Traversal cost(const Accelerator& tree, std::size_t rays) {
    Draw draw(3);
    Traversal traversal;
    for (std::size_t i = 0; i < rays; ++i) tree.closest(ray_at(draw), traversal);
    return traversal;
}

}  // namespace

TEST_CASE("a tree's outline has every bounded primitive in one leaf, below one root") {
    Scene scene = bumpy(1);
    scene.objects.push_back(object(Plane{{0, -2, 0}, {0, 1, 0}}));
    scene.objects.push_back(object(Sphere{{3, 0, 0}, 1}));
    for (const std::string& name : trees) {
        INFO(name);
        const Outline outline = make_accelerator(name, scene)->outline();
        std::multiset<std::uint32_t> primitives, nodes{0};
        for (const auto& node : outline.nodes) {
            CHECK(node.children.empty() != node.primitives.empty());
            primitives.insert(node.primitives.begin(), node.primitives.end());
            nodes.insert(node.children.begin(), node.children.end());
        }
        std::multiset<std::uint32_t> every, all_nodes;
        for (std::uint32_t i = 0; i < 82; ++i)
            if (i != 80) every.insert(i);  // 80 is the plane
        for (std::uint32_t i = 0; i < outline.nodes.size(); ++i) all_nodes.insert(i);
        CHECK(primitives == every);
        CHECK(nodes == all_nodes);
    }
}

TEST_CASE("the outline of one primitive is a leaf below a root, of none nothing") {
    const Scene one{.objects = {object(Sphere{{0, 0, 0}, 1})}};
    for (const std::string& name : trees) {
        const Outline outline = make_accelerator(name, one)->outline();
        REQUIRE(outline.nodes.size() == 2);
        CHECK(outline.nodes[1].primitives == std::vector<std::uint32_t>{0});
        CHECK(make_accelerator(name, {})->outline().nodes.empty());
        CHECK(make_accelerator(name, {})->visits({}).empty());
    }
}

TEST_CASE("what a ray visits is what closest() counts") {
    const Scene scene = bumpy(2);
    for (const std::string& name : trees) {
        const auto tree = make_accelerator(name, scene);
        Draw draw(1);
        for (int i = 0; i < 200; ++i) {
            const Ray ray = ray_at(draw);
            Traversal traversal;
            tree->closest(ray, traversal);
            std::size_t inner = 0, tests = 0;
            for (const Visit& visit : tree->visits(ray)) {
                inner += visit.kind == Visit::Kind::inner;
                tests += visit.tests;
                CHECK((visit.kind == Visit::Kind::leaf) == (visit.tests > 0));
            }
            CHECK(inner == traversal.steps);
            CHECK(2 * inner == traversal.box_tests);
            CHECK(tests == traversal.primitive_tests);
        }
    }
}

TEST_CASE("a place to cut that is chosen by cost saves tests; closer bounds save visits") {
    const Scene scene = bumpy(4);
    const auto of = [&](SplitRule rule) { return cost(BoxBvh(scene, {.rule = rule}), 2'000); };
    const Traversal median = of(SplitRule::median), binned = of(SplitRule::binned), sweep = of(SplitRule::sweep);
    CHECK(binned.box_tests + 2 * binned.primitive_tests < median.box_tests + 2 * median.primitive_tests);
    CHECK(sweep.primitive_tests < median.primitive_tests);
    CHECK(cost(SlabBvh(scene), 2'000).steps < cost(BoxBvh(scene), 2'000).steps);
    CHECK(cost(BoxBvh(scene), 2'000).steps < cost(SphereBvh(scene), 2'000).steps);
}

TEST_CASE("every rule for cutting gives a tree that answers as the list does") {
    Draw scenes(5);
    for (int i = 0; i < 6; ++i) {
        const Scene scene = i == 0 ? scene_of(floor_of(6)) : any_scene(scenes, 40);
        const auto list = make_accelerator("list", scene);
        for (const auto rule : {SplitRule::median, SplitRule::binned, SplitRule::sweep}) {
            const BoxBvh tree(scene, {.rule = rule, .largest_leaf = 2});
            Draw draw(11);
            for (int k = 0; k < 500; ++k) {
                const Ray ray = ray_at(draw);
                Traversal traversal;
                const auto given = tree.closest(ray, traversal), expected = list->closest(ray, traversal);
                CHECK(given.has_value() == expected.has_value());
                if (given && expected) CHECK(given->primitive == expected->primitive);
            }
        }
    }
}
