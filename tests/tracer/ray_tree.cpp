#include "catch.h"
#include "tracer/glass.h"

#include "raylab/report/ray_tree/ray_tree_difference.h"
#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/whitted.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr double rounding = 1e-12;  // a few hundred sums of numbers around 1

Color sum_of_contributions(const RayTree& tree) {
    Color sum{0, 0, 0};
    for (const auto& node : tree.nodes)
        if (node.kind != RayKind::shadow) sum += node.contribution;
    return sum;
}

// The trees of every 7th pixel.
std::vector<RayTree> trees_of(const Scene& scene, const WhittedOptions& options) {
    const auto accelerator = make_accelerator("list", scene);
    const auto frame = camera_frame(scene.camera, scene.image);
    std::vector<RayTree> trees;
    for (int pixel = 0; pixel < scene.image.width * scene.image.height; pixel += 7)
        trees.push_back(ray_tree(scene, *accelerator, options,
                                 eye_ray(frame, pixel % scene.image.width + 0.5, pixel / scene.image.width + 0.5)));
    return trees;
}

RayTree a_tree() {
    const Scene scene = glass_scene();
    const auto accelerator = make_accelerator("list", scene);
    return ray_tree(scene, *accelerator, {}, eye_ray(camera_frame(scene.camera, scene.image), 31.5, 20.5));
}

}  // namespace

TEST_CASE("the contributions of a tree add up to its pixel, whatever the models") {
    std::vector<Scene> scenes{glass_scene(), read_scene(RAYLAB_SOURCE "/chapters/04_transforms/scene.toml")};
    scenes[1].image = {48, 36};
    for (auto& material : scenes[1].materials) material.kr = 0.4;
    const std::vector<WhittedOptions> models{{},
                                             {.depth = 9},
                                             {.depth = 9, .threshold = 0.02},
                                             {.reflectance = WhittedOptions::Reflectance::fresnel},
                                             {.shadows = WhittedOptions::Shadows::none}};
    for (const auto& scene : scenes)
        for (const auto& model : models)
            for (const auto& tree : trees_of(scene, model))
                if (const Color sum = sum_of_contributions(tree); !(glm::length(sum - tree.pixel) <= rounding))
                    FAIL("a pixel that is no sum");
}

TEST_CASE("a shadow ray's share is part of its parent's local colour") {
    const Scene scene = glass_scene();  // without ambient light on glass and mirror: shadow rays bring all of it
    for (const auto& tree : trees_of(scene, {})) {
        const auto below = children(tree);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            const auto& node = tree.nodes[i];
            if (node.object != "sphere 1") continue;
            Color brought{0, 0, 0};
            for (const std::size_t child : below[i])
                if (tree.nodes[child].kind == RayKind::shadow) brought += tree.nodes[child].local;
            CHECK(glm::length(brought - node.local) <= rounding);
        }
    }
}

TEST_CASE("a tree is the same as itself, and as one of the same rays traced in another order") {
    RayTree tree = a_tree();
    CHECK_FALSE(first_difference(tree, a_tree()));
    REQUIRE(tree.nodes.size() > 10);
    RayTree turned{.nodes = {tree.nodes[0]}, .pixel = tree.pixel};  // every node's children the other way round
    const auto below = children(tree);
    const auto add = [&](const auto& self, std::size_t from, std::size_t to) -> void {
        for (auto child = below[from].rbegin(); child != below[from].rend(); ++child) {
            turned.nodes.push_back(tree.nodes[*child]);
            turned.nodes.back().parent = to;
            self(self, *child, turned.nodes.size() - 1);
        }
    };
    add(add, 0, 0);
    REQUIRE(turned.nodes.size() == tree.nodes.size());
    CHECK_FALSE(first_difference(turned, tree));
}

TEST_CASE("each field of a node is compared, and what differs is told") {
    const RayTree tree = a_tree();
    const std::size_t last = tree.nodes.size() - 1;
    const auto field = [&](const auto& change) {
        RayTree other = tree;
        change(other.nodes[last]);
        const auto difference = first_difference(other, tree);
        return difference ? difference->fields.front().name : "none";
    };
    CHECK(field([](RayNode&) {}) == "none");
    CHECK(field([](RayNode& n) { n.kind = RayKind::eye; }) == "branch");  // no such branch here, and one too many there
    CHECK(field([](RayNode& n) { n.object = "another"; }) == "object");
    CHECK(field([](RayNode& n) { n.ended = Ending::missed; }) == "ended");
    CHECK(field([](RayNode& n) { n.throughput *= 1.001; }) == "throughput");
    RayTree other = tree;
    const auto of_root = [&](const auto& change) {
        other = tree;
        change(other.nodes[0]);
        const auto difference = first_difference(other, tree);
        return difference ? difference->fields.front().name : "none";
    };
    CHECK(of_root([](RayNode& n) { n.ray.direction.x += 0.001f; }) == "direction");
    CHECK(of_root([](RayNode& n) { n.t *= 1.001; }) == "t");
    CHECK(of_root([](RayNode& n) { n.t = INFINITY; }) == "t");
    CHECK(of_root([](RayNode& n) { n.point.x += 0.001; }) == "point");
    CHECK(of_root([](RayNode& n) { n.normal = -n.normal; }) == "normal");
    CHECK(of_root([](RayNode& n) { n.local *= 2; }) == "local colour");
    CHECK(of_root([](RayNode& n) { n.local.x = NAN; }) == "local colour");
    CHECK(of_root([](RayNode& n) { n.contribution *= 2; }) == "contribution");
    CHECK(of_root([](RayNode& n) { n.t *= 1 + 1e-7; }) == "none");
    other = tree;
    other.nodes[0].t = INFINITY;
    CHECK(first_difference(tree, other)->fields.front().name == "t");
    other = tree;
    other.pixel *= 2;
    CHECK(first_difference(other, tree)->fields.front().name == "pixel");
}

TEST_CASE("the difference nearest to the eye is the first, and a missing branch is told by its parent") {
    const RayTree tree = a_tree();
    RayTree other = tree;
    for (auto& node : other.nodes)
        if (node.depth >= 2 && node.kind != RayKind::shadow) node.throughput *= 2;
    const auto nearest = first_difference(other, tree);
    REQUIRE(nearest);
    CHECK(tree.nodes[nearest->expected].depth == 2);
    CHECK(nearest->place == "the eye ray's reflected ray");
    for (auto& node : other.nodes)
        if (node.depth == 2 && node.kind != RayKind::shadow) node.throughput /= 2;
    CHECK(first_difference(other, tree)->place == "the reflected ray below eye, transmitted");

    other = tree;
    other.nodes.resize(1);
    const auto missing = first_difference(other, tree);
    REQUIRE(missing);
    CHECK(missing->in == RayTreeDifference::In::expected);
    CHECK(missing->got == 0);
    CHECK(missing->fields.front().got == "none");
    const auto extra = first_difference(tree, other);
    REQUIRE(extra);
    CHECK(extra->in == RayTreeDifference::In::got);
}

TEST_CASE("of two siblings the one that differs in the earlier field is first") {
    const RayTree tree = a_tree();
    RayTree other = tree;
    std::size_t reflected = 0, transmitted = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].parent == 0 && tree.nodes[i].kind == RayKind::reflected) reflected = i;
        if (tree.nodes[i].parent == 0 && tree.nodes[i].kind == RayKind::transmitted) transmitted = i;
    }
    REQUIRE(reflected < transmitted);
    other.nodes[reflected].throughput *= 2;
    CHECK(first_difference(other, tree)->expected == reflected);
    other.nodes[transmitted].t *= 2;
    CHECK(first_difference(other, tree)->expected == transmitted);
}

TEST_CASE("a local colour that differs is told with the shadow ray that is to blame") {
    const RayTree tree = a_tree();
    RayTree other = tree;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].kind == RayKind::shadow && tree.nodes[i].parent == 0 && tree.nodes[i].light == 1) {
            other.nodes[i].ended = Ending::blocked;
            other.nodes[0].local -= tree.nodes[i].local;
        }
    const auto difference = first_difference(other, tree);
    REQUIRE(difference);
    CHECK(to_string(*difference).find("local colour expected") != std::string::npos);
    CHECK(to_string(*difference).find("shadow ray to light 1 expected reached, got blocked") != std::string::npos);
}
