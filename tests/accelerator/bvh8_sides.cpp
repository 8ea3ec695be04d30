#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/loose_triangles.h"

#include <algorithm>
#include <cmath>

// Triangles seen from the front alone lie in the same leaves as those that are seen from both sides.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

Triangle turned(const Triangle& t) { return {t.a, t.c, t.b}; }

// Beside each other, over each other, back to back, small enough to underflow and as large as floats may be.
std::vector<Triangle> any_triangles(Draw& draw) {
    const float scale = draw.one_in(3) ? std::ldexp(1.0f, draw.integer(-120, 100)) : 1;
    const int count = draw.integer(1, 60);
    const bool is_flat = draw.one_in(4);
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        if (i > 0 && draw.one_in(3)) {
            const Triangle& before = triangles[static_cast<std::size_t>(draw.integer(0, i - 1))];
            triangles.push_back(draw.one_in(2) ? turned(before) : before);
            continue;
        }
        const auto corner = [&] {
            Vec3f at = draw.one_in(2) ? draw.on_lattice(-2, 2) : draw.in_cube(2);
            if (is_flat) at.z = 1;
            return at * scale;
        };
        triangles.push_back({corner(), corner(), corner()});
    }
    return triangles;
}

// Some as objects of their own, some in meshes of two and of all that are left.
Scene scene_of_any_sides(Draw& draw, const std::vector<Triangle>& triangles) {
    Scene scene;
    const auto add = [&](Shape shape) {
        scene.objects.push_back(object(std::move(shape)));
        scene.objects.back().sides = draw.one_in(2) ? Sides::front : any_sides(draw);
    };
    std::size_t i = 0;
    for (const int most = draw.integer(0, 60); i < triangles.size() && static_cast<int>(i) < most; ++i)
        add(triangles[i]);
    const auto mesh_up_to = [&](std::size_t end) {
        const auto from = triangles.begin() + static_cast<std::ptrdiff_t>(i);
        add(mesh_of({from, triangles.begin() + static_cast<std::ptrdiff_t>(end)}));
        i = end;
    };
    for (int pairs = draw.integer(0, 4); pairs > 0 && i + 2 <= triangles.size(); --pairs) mesh_up_to(i + 2);
    if (draw.one_in(3)) add(Sphere{draw.in_cube(1), 0.5f});
    if (i < triangles.size()) mesh_up_to(triangles.size());
    return scene;
}

Ray to(Draw& draw, const Triangle& triangle, float size) {
    const auto [a, b, c] = triangle;
    const double v = draw.one_in(3) ? draw.integer(0, 1) : draw.number(0, 1);
    const double w = draw.one_in(3) ? 0 : draw.number(0, 1 - v);
    const Vec3d point = convert<double>(a) + v * (convert<double>(b) - convert<double>(a)) +
                        w * (convert<double>(c) - convert<double>(a));
    Ray ray = through(draw.in_cube(draw.one_in(2) ? 8 : 1000) * size, point);
    if (draw.one_in(4)) ray.range = {draw.uniform(-1, 1), draw.uniform(1, 3)};
    return ray;
}

std::optional<std::string> compare(Draw& draw) {
    const std::vector<Triangle> triangles = any_triangles(draw);
    const Scene scene = scene_of_any_sides(draw, triangles);
    const auto any_object = [&] {
        return static_cast<std::uint32_t>(draw.integer(0, static_cast<int>(scene.objects.size()) - 1));
    };
    const auto list = make_accelerator("list", scene);
    for (const char* name : {"bvh8", "bvh8_splits"}) {
        const auto tree = make_accelerator(name, scene);
        Traversal of_list, of_tree;
        of_tree.toward(0);
        for (int i = 0; i < 30; ++i) {
            const auto& aimed =
                triangles[static_cast<std::size_t>(draw.integer(0, static_cast<int>(triangles.size()) - 1))];
            Ray ray = to(draw, aimed, std::max({std::abs(aimed.a.x), std::abs(aimed.b.y), 0x1p-120f}));
            if (draw.one_in(3)) ray.leaving = {any_object(), 0};
            if (!same(list->closest(ray, of_list), tree->closest(ray, of_tree)))
                return std::string(name) + ", closest: " + words(ray);
            if (list->occluded(ray, of_list) != tree->occluded(ray, of_tree))
                return std::string(name) + ", occluded: " + words(ray);
        }
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("bvh8 answers as the list does about triangles of which some are seen from one side") {
    CHECK(faults(4000, compare) == "");
}

TEST_CASE("bvh8 finds the object of a triangle past meshes without any") {
    Scene scene;
    const auto empty = std::make_shared<const Mesh>();
    for (int i = 0; i < 3; ++i) {
        scene.objects.push_back(object(empty));
        scene.objects.push_back(object(empty));
        const float z = static_cast<float>(i);
        scene.objects.push_back(object(Triangle{{-1, -1, z}, {1, -1, z}, {0, 1, z}}));
    }
    const auto list = make_accelerator("list", scene), tree = make_accelerator("bvh8", scene);
    Traversal of_list, of_tree;
    Ray ray{{0, 0, -1}, {0, 0, 1}};
    for (const std::uint32_t first : {2u, 5u, 8u}) {
        const auto hit = tree->closest(ray, of_tree);
        CHECK(same(list->closest(ray, of_list), hit));
        REQUIRE(hit);
        CHECK(hit->primitive == Primitive{first, 0});
        ray.origin.z = static_cast<float>(hit->t) + ray.origin.z;
        ray.leaving = hit->primitive;
    }
    CHECK_FALSE(tree->closest(ray, of_tree));
}

TEST_CASE("triangles seen from the front alone are missed from behind, exactly and in floats") {
    Scene scene = scene_of(floor_of(4));  // y = 1, normals downward
    scene.objects[0].sides = Sides::front;
    const Bvh8 tree(scene);
    Traversal traversal;
    for (const auto& [y, is_hit] : {std::pair{0.0f, true}, {2.0f, false}}) {
        const Ray ray{{1.25f, y, 1.5f}, {0, 1 - y, 0}};
        CHECK(tree.closest(ray, traversal).has_value() == is_hit);
        CHECK(tree.occluded(ray, traversal) == is_hit);
        CHECK(tree.closest_in_floats(ray, traversal).has_value() == is_hit);
    }
    CHECK(traversal.exact_decisions == 0);
}
