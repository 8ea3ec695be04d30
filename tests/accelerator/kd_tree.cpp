#include "raylab/accelerator/split_tree/kd_tree.h"
#include "accelerator/instruction_sets.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/kd8/kd8.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct Rule {
    const char* name;
    PlaneRule rule;
};

std::vector<Rule> rules() {
    return {{"spatial median", spatial_median()},
            {"object median", object_median()},
            {"surface area", surface_area_heuristic()}};
}

Scene bumpy(int levels) {
    Scene scene;
    scene.objects.push_back(object(std::make_shared<const Mesh>(bumpy_sphere(levels))));
    return scene;
}

struct Plane3 {
    int axis;
    float at;
};

// The planes of a structure, taken from its outline.
std::vector<Plane3> planes_of(const Outline& outline) {
    std::vector<Plane3> planes;
    for (const Outline::Node& node : outline.nodes) {
        if (node.children.empty()) continue;
        const Box& whole = std::get<Box>(node.bound);
        for (const std::uint32_t child : node.children) {
            const Box& cell = std::get<Box>(outline.nodes[child].bound);
            for (int axis = 0; axis < 3; ++axis) {
                if (cell.max[axis] != whole.max[axis]) planes.push_back({axis, cell.max[axis]});
                if (cell.min[axis] != whole.min[axis]) planes.push_back({axis, cell.min[axis]});
            }
        }
    }
    return planes;
}

// A ray that starts in one of the planes, mostly stays in it, and now and then lies in two of them at once.
Ray in_planes(Draw& draw, const std::vector<Plane3>& planes) {
    Ray ray{draw.in_cube(2), draw.one_in(3) ? draw.lattice_direction(1) : draw.in_cube(1)};
    for (int i = 0; i < 2; ++i) {
        const Plane3 plane = planes[static_cast<std::size_t>(draw.integer(0, static_cast<int>(planes.size()) - 1))];
        ray.origin[plane.axis] = plane.at;
        if (draw.one_in(2)) ray.direction[plane.axis] = draw.one_in(2) ? 0.0f : -0.0f;
    }
    if (draw.one_in(3)) ray.range.min = -std::numeric_limits<float>::infinity();
    if (ray.direction == Vec3f(0)) ray.direction = {0, 0, 1};
    return ray;
}

}  // namespace

TEST_CASE("rays in the planes that cut the cells, and from them, hit what the list hits") {
    Draw draw(3);
    for (const Scene& scene : {bumpy(2), scene_of(floor_of(6)), scene_of(soup(draw, 100, 2)), any_scene(draw, 30)}) {
        const auto list = make_accelerator("list", scene);
        const auto compare = [&](const Accelerator& tree) {
            const auto planes = planes_of(tree.outline());
            REQUIRE_FALSE(planes.empty());
            CHECK(faults(5'000, [&](Draw& drawn) -> std::optional<std::string> {
                      const Ray ray = in_planes(drawn, planes);
                      Traversal traversal;
                      const auto hit = list->closest(ray, traversal);
                      const bool is_right =
                          same(hit, tree.closest(ray, traversal)) && tree.occluded(ray, traversal) == hit.has_value();
                      return is_right ? std::nullopt : std::optional(words(ray));
                  }) == "");
        };
        for (const auto& [name, rule] : rules()) {
            INFO(name);
            compare(KdTree(scene, rule));
            with_each_instruction_set([&] { compare(Kd8(scene, rule)); });
        }
    }
}

TEST_CASE("what a ray visits of a kd-tree is what closest() counts") {
    const Scene scene = bumpy(3);
    for (const auto& [name, rule] : rules()) {
        const KdTree tree(scene, rule);
        CHECK(faults(200, [&](Draw& draw) -> std::optional<std::string> {
                  const Ray ray = through(draw.in_cube(3), convert<double>(draw.in_cube(1)));
                  Traversal traversal;
                  tree.closest(ray, traversal);
                  const auto visits = tree.visits(ray);
                  std::size_t tests = 0;
                  for (const Visit& visit : visits) tests += visit.tests;
                  if (tests == traversal.primitive_tests && visits.size() == traversal.steps) return std::nullopt;
                  return "visits() and closest() went different ways";
              }) == "");
    }
}

TEST_CASE("a primitive that is found again in the next cell costs no exact decision") {
    const Scene scene = bumpy(4);
    const KdTree tree(scene, spatial_median());
    Traversal traversal;
    Draw draw(5);
    for (int i = 0; i < 2'000; ++i)
        tree.closest(through(draw.in_cube(3), convert<double>(draw.in_cube(0.5))), traversal);
    CHECK(traversal.primitive_tests > 2'000);
    CHECK(traversal.exact_decisions == 0);
}

TEST_CASE("the heuristic's tree costs less than the medians', and cuts empty space off") {
    const Scene scene = bumpy(5);
    std::vector<Traversal> counts;
    std::vector<KdTree::Size> sizes;
    for (const auto& [name, rule] : rules()) {
        const KdTree tree(scene, rule);
        Draw draw(6);
        Traversal traversal;
        for (int i = 0; i < 2'000; ++i)
            tree.closest(through(draw.in_cube(3), convert<double>(draw.in_cube(1))), traversal);
        counts.push_back(traversal);
        sizes.push_back(tree.size());
    }
    CHECK(2 * counts[2].primitive_tests < counts[1].primitive_tests);
    CHECK(counts[2].steps < counts[0].steps);
    CHECK(counts[2].primitive_tests + counts[2].steps < counts[0].primitive_tests + counts[0].steps);
    CHECK(4 * sizes[2].empty_leaves > sizes[2].leaves);
    CHECK(20 * sizes[1].empty_leaves < sizes[1].leaves);
}

TEST_CASE("a kd-tree's outline holds every primitive, and its cells fill the whole") {
    const Scene scene = bumpy(3);
    for (const auto& [name, rule] : rules()) {
        const Outline outline = KdTree(scene, rule).outline();
        std::vector<bool> found(20u << 6);
        double volume = 0;
        for (const Outline::Node& node : outline.nodes) {
            for (const std::uint32_t place : node.primitives) found[place] = true;
            const Box& box = std::get<Box>(node.bound);
            const Vec3d size = convert<double>(box.max) - convert<double>(box.min);
            if (node.children.empty()) volume += size.x * size.y * size.z;
        }
        CHECK(std::ranges::count(found, false) == 0);
        const Box& whole = std::get<Box>(outline.nodes[0].bound);
        const Vec3d size = convert<double>(whole.max) - convert<double>(whole.min);
        CHECK_THAT(volume, WithinRel(size.x * size.y * size.z, 1e-12));
    }
}

TEST_CASE("leaves stay few where cuts part nothing: a thousand spheres about one another") {
    Scene scene;
    for (int i = 0; i < 1'000; ++i) scene.objects.push_back(object(Sphere{{0, 0, 0}, 1 + 0.001f * cast<float>(i)}));
    for (const auto& [name, rule] : rules()) CHECK(KdTree(scene, rule).size().references <= 102'000);
}
