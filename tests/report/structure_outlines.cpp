#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/report/structure/bound.h"
#include "raylab/report/structure/structure_drawing.h"

#include "catch.h"

#include <set>

// Tests of every structure's outline for drawings, by its name.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Some of all shapes except planes, and a mesh.
Scene bounded_scene() {
    Draw draw(11);
    Scene scene = any_scene(draw, 40);
    std::erase_if(scene.objects, [](const Object& each) { return std::holds_alternative<Plane>(each.shape); });
    scene.objects.push_back(object(mesh_of(soup(draw, 60, 3))));
    return scene;
}

std::vector<Ray> rays_through(const Scene& scene) {
    Draw draw(12);
    const SceneRays source(scene);
    std::vector<Ray> rays;
    for (int i = 0; i < 300; ++i)
        rays.push_back(source.draw(draw, static_cast<std::size_t>(i) % SceneRays::kinds().size()));
    return rays;
}

// Every structure that visits cells or nodes; a list takes no steps.
std::vector<std::string> drawn_structures(const Scene& scene) {
    const auto rays = rays_through(scene);
    std::vector<std::string> names = accelerator_names();
    std::erase_if(names, [&](const std::string& name) {
        const auto structure = make_accelerator(name, scene);
        Traversal traversal;
        for (const Ray& ray : rays) structure->closest(ray, traversal);
        return traversal.steps == 0;
    });
    REQUIRE(!names.empty());
    return names;
}

std::set<std::uint32_t> places_in(const Outline& outline) {
    std::set<std::uint32_t> places;
    for (const auto& node : outline.nodes) places.insert(node.primitives.begin(), node.primitives.end());
    return places;
}

}  // namespace

TEST_CASE("every structure's outline holds every primitive, as a tree from its first node") {
    const Scene scene = bounded_scene();
    const std::size_t objects = scene.objects.size() - 1;
    for (const std::string& name : drawn_structures(scene)) {
        INFO(name);
        const Outline outline = make_accelerator(name, scene)->outline();
        REQUIRE(outline.nodes.size() > 1);
        const auto places = places_in(outline);
        CHECK(places.size() == objects + 60);
        CHECK(*places.rbegin() == objects + 59);
        std::multiset<std::uint32_t> children;
        for (const auto& node : outline.nodes) children.insert(node.children.begin(), node.children.end());
        CHECK(children.size() == outline.nodes.size() - 1);
        CHECK(children.count(0) == 0);
    }
}

TEST_CASE("visits are what closest() does: their tests are its tests, and a hit lies in a visited leaf") {
    const Scene scene = bounded_scene();
    for (const std::string& name : drawn_structures(scene)) {
        INFO(name);
        const auto structure = make_accelerator(name, scene);
        const Outline outline = structure->outline();
        std::size_t with_leaves = 0;
        for (const Ray& ray : rays_through(scene)) {
            Traversal traversal;
            const auto hit = structure->closest(ray, traversal);
            const auto visits = structure->visits(ray);
            if (visits.empty()) {  // its bounds do not cover these numbers, so it tested everything, like a list
                CHECK(traversal.steps == 0);
                continue;
            }
            std::size_t tests = 0, leaves = 0;
            for (const Visit& visit : visits) {
                tests += visit.tests;
                leaves += visit.kind == Visit::Kind::leaf;
            }
            CHECK(tests == traversal.primitive_tests);
            if (hit) CHECK(leaves > 0);
            with_leaves += leaves > 0;
        }
        CHECK(with_leaves > 100);
    }
}

TEST_CASE("a ray's visited leaves are leaves of the outline") {
    const Scene scene = bounded_scene();
    for (const std::string& name : drawn_structures(scene)) {
        INFO(name);
        const auto structure = make_accelerator(name, scene);
        const Outline outline = structure->outline();
        std::size_t found = 0, leaves = 0;
        const auto rays = rays_through(scene);
        for (std::size_t i = 0; i < 60; ++i)
            for (const Visit& visit : structure->visits(rays[i])) {
                if (visit.kind != Visit::Kind::leaf) continue;
                ++leaves;
                found +=
                    std::ranges::any_of(outline.nodes, [&](const auto& node) { return same(node.bound, visit.bound); });
            }
        CHECK(found == leaves);
    }
}
