#include "catch.h"
#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/uneven.h"
#include "raylab/geometry/bounds/box.h"

#include <algorithm>
#include <ranges>
#include <span>

using namespace raylab;

namespace {

/// How many nodes are visited by rays from the lower side of the box to its upper side.
std::uint64_t nodes_visited(const Bvh8Contents& contents, const Box& box) {
    const Bvh8Walks walks = best_bvh8_walks();
    adversarial::Draw draw(3);
    const auto point = [&](float height) {
        Vec3f p = convert<float>(box.center()) + 0.5f * (box.max - box.min) * draw.in_cube(1);
        p.y = height;
        return p;
    };
    Traversal traversal;
    for (int i = 0; i < 2'000; ++i) {
        const Vec3f from = point(box.min.y);
        const Ray ray{.origin = from, .direction = point(box.max.y) - from, .range = {0, 1}};
        walks.occluded(contents, ray, traversal);
    }
    return traversal.steps;
}

/// Hair, and a square across all of it.
std::vector<Triangle> hair_and_wall(const Box& box, const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) triangles.push_back(mesh.triangle(face));
    const float y = convert<float>(box.center()).y;
    const Vec3f a(box.min.x, y, box.min.z), b(box.max.x, y, box.min.z), c(box.max.x, y, box.max.z),
        d(box.min.x, y, box.max.z);
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
    return triangles;
}

Bvh8Nodes with_children_turned_round(Bvh8Nodes tree) {
    for (Bvh8Node& node : tree.nodes) {
        const auto count = std::ranges::find_if(node.children, &Bvh8Child::is_root) - node.children.begin();
        std::reverse(node.children.begin(), node.children.begin() + count);
        for (auto& row : node.planes) std::reverse(row.begin(), row.begin() + count);
    }
    return tree;
}

}  // namespace

TEST_CASE("a ray that asks for any hit visits first what is large and cheap, and with that half as many nodes") {
    const Mesh mesh = hair(6);
    Box box;
    for (const Vec3f& vertex : mesh.vertices) box = unite(box, {vertex, vertex});
    const Scene scene = adversarial::scene_of(hair_and_wall(box, mesh));
    const Bvh8Contents turned_round(scene, Bvh8BuildOptions{},
                                    [](const TriangleRuns& triangles, std::span<const Box> others) {
                                        return with_children_turned_round(build_bvh8_nodes(triangles, others));
                                    });
    const std::uint64_t ordered = nodes_visited(Bvh8Contents(scene), box), turned = nodes_visited(turned_round, box);
    INFO(ordered << " nodes, and in the opposite order " << turned);
    CHECK(2 * ordered < turned);
}
