#include "raylab/accelerator/bvh/spatial_splits.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/bvh/bvh.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <set>
#include <span>

// The differential tester in tests/report checks that trees with spatial splits answer as the list does, because
// "bvh_splits" is a name of make_accelerator().

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Scene even() {
    Scene scene;
    scene.objects.push_back(object(std::make_shared<Mesh>(bumpy_sphere(4))));
    return scene;
}

// A few triangles are long, thin and slanted and go through the whole scene: the box about each contains half of the
// others.
Scene wired() {
    Scene scene = even();
    Draw draw(2);
    for (int i = 0; i < 50; ++i) {
        const Vec3f middle = draw.in_cube(0.5f), along = draw.in_cube(2), across = draw.in_cube(0.01f);
        scene.objects.push_back(object(Triangle{middle - along, middle + along, middle + along + across}));
    }
    return scene;
}

BoxBvh tree_with(const Scene& scene, const SpatialSplits& options) {
    const SortedPrimitives sorted(scene);
    return {sorted, build_tree_with_spatial_splits(sorted, options)};
}

Traversal cost(const Accelerator& tree) {
    Draw draw(3);
    Traversal traversal;
    for (int i = 0; i < 2'000; ++i) tree.closest(through(draw.in_cube(4), convert<double>(draw.in_cube(1))), traversal);
    return traversal;
}

bool contains(const Box& box, const Vec3d& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= box.min[axis] && p[axis] <= box.max[axis])) return false;
    return true;
}

/// Whether a point of the primitive lies in every box on the way to one of the leaves that list it.
bool reaches(const BoxTree& tree, std::uint32_t primitive, const Vec3d& point, std::size_t node = 0) {
    for (const std::size_t side : {0, 1}) {
        const auto& [planes, first, count] = tree.nodes[node];
        if (!contains(box_of(planes, side), point)) continue;
        if (count[side] == 0 && reaches(tree, primitive, point, first[side])) return true;
        for (std::uint32_t i = first[side]; i < first[side] + count[side]; ++i)
            if (tree.order[i] == primitive) return true;
    }
    return false;
}

// Corners are multiples of 2^-20 and weights are sixteenths, so that points of the triangles are exact in doubles.
std::optional<std::string> lose_a_point(Draw& draw) {
    std::vector<Triangle> triangles;
    const auto number = [&] { return std::ldexp(cast<float>(draw.integer(-(1 << 22), 1 << 22)), -20); };
    const auto corner = [&] { return draw.one_in(3) ? draw.on_lattice(-4, 4) : Vec3f(number(), number(), number()); };
    const float scale = draw.one_in(3) ? std::ldexp(1.0f, draw.integer(-100, 80)) : 1;
    for (int i = draw.integer(1, 30); i > 0; --i)
        triangles.push_back({corner() * scale, corner() * scale, corner() * scale});
    const Scene scene = scene_of(triangles);
    const auto tree = build_tree_with_spatial_splits(SortedPrimitives(scene),
                                                     {.max_duplicates = 8, .min_overlap = 0, .largest_leaf = 1});
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        const int v = draw.integer(0, 16), w = draw.integer(0, 16 - v);
        const Vec3d point =
            (convert<double>(a) * (16.0 - v - w) + convert<double>(b) * double(v) + convert<double>(c) * double(w)) /
            16.0;
        if (!reaches(tree, i, point)) return "a point of a triangle is in no leaf that has the triangle";
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("every point of a triangle is in a leaf that has the triangle, and in all boxes above it") {
    CHECK(faults(3'000, lose_a_point) == "");
}

TEST_CASE("a primitive is at most once in a leaf, and there are no more duplicates than allowed") {
    const Scene scene = wired();
    const SortedPrimitives sorted(scene);
    const std::size_t all = sorted.boxes.size();
    for (const double largest : {0.0, 0.05, 0.1}) {
        const BoxTree tree = build_tree_with_spatial_splits(sorted, {.max_duplicates = largest});
        const auto allowed = static_cast<std::size_t>(static_cast<double>(all) * (1 + largest));
        CHECK(tree.order.size() <= allowed);
        CHECK(tree.order.size() + 20 > allowed);
        CHECK(std::set(tree.order.begin(), tree.order.end()).size() == all);
        for (const auto& node : tree.nodes)
            for (const std::size_t side : {0, 1}) {
                const auto leaf =
                    std::span(tree.order).subspan(node.count[side] > 0 ? node.first[side] : 0, node.count[side]);
                CHECK(std::set(leaf.begin(), leaf.end()).size() == leaf.size());
            }
    }
}

TEST_CASE("a few long triangles among small ones cost less than half where they are cut; small ones are left whole") {
    const Scene scene = wired();
    const Traversal whole = cost(BoxBvh(scene)), cut = cost(tree_with(scene, {}));
    CHECK(2 * cut.primitive_tests < whole.primitive_tests);
    CHECK(2 * cut.box_tests < whole.box_tests);
    const Scene small = even();
    const SortedPrimitives sorted(small);
    CHECK(50 * build_tree_with_spatial_splits(sorted).order.size() < 51 * sorted.boxes.size());
}

TEST_CASE("without duplicates it is the tree that is cut between centers") {
    const Scene scene = wired();
    const Traversal none = cost(tree_with(scene, {.max_duplicates = 0})), plain = cost(BoxBvh(scene));
    CHECK(none.primitive_tests == plain.primitive_tests);
    CHECK(none.box_tests == plain.box_tests);
}

TEST_CASE("duplicates are allowed by a number after the name") {
    const Scene scene = wired();
    CHECK(make_accelerator("bvh_splits:0", scene)->bytes() == BoxBvh(scene).bytes());
    CHECK(make_accelerator("bvh_splits:0.1", scene)->bytes() < make_accelerator("bvh_splits", scene)->bytes());
    CHECK_THROWS(make_accelerator("bvh_splits:-1", scene));
}
