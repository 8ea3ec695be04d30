#include "accelerator/instruction_sets.h"
#include "catch.h"
#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/accelerator/kd8/kd8.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <bit>
#include <optional>
#include <type_traits>
#include <vector>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Answers and counts of a tree traversed with one instruction set, as bits.
struct Walked {
    std::vector<std::uint64_t> answers;
    std::uint64_t steps, box_tests, primitive_tests, exact_decisions;

    friend bool operator==(const Walked&, const Walked&) = default;
};

template <class Tree>
Walked walked(const Scene& scene) {
    const Tree tree(scene);
    Draw draw(3);
    Traversal traversal;
    Walked result{};
    const auto add = [&](const std::optional<Hit>& hit) {
        result.answers.push_back(hit ? std::bit_cast<std::uint64_t>(hit->t) : 0);
        result.answers.push_back(hit ? hit->primitive.part : ~std::uint64_t{0});
    };
    std::vector<Ray> rays;
    for (int i = 0; i < 20'000; ++i) {
        Ray ray{draw.in_cube(4), draw.in_cube(1)};
        if (draw.one_in(4)) ray.direction[draw.integer(0, 2)] = 0;
        if (ray.direction == Vec3f(0)) ray.direction = {1, 0, 0};
        if (draw.one_in(3)) ray.range = {0, draw.uniform(0, 4)};
        add(tree.closest(ray, traversal));
        result.answers.push_back(tree.occluded(ray, traversal));
        rays.push_back(ray);
    }
    if constexpr (std::is_same_v<Tree, Bvh8>)
        for (const auto& hit : tree.closest_in_turns(rays, 1000, traversal)) add(hit);
    result.steps = traversal.steps;
    result.box_tests = traversal.box_tests;
    result.primitive_tests = traversal.primitive_tests;
    result.exact_decisions = traversal.exact_decisions;
    return result;
}

}  // namespace

// (Answers are exact with each. Counts could differ by a box in very many, between instruction sets that multiply and
// subtract at once and those that do not; among these rays they do not.)
TEMPLATE_TEST_CASE("a tree gives the same answers and counts with every instruction set", "", Bvh8, Kd8) {
    Draw draw(11);
    Scene scene = scene_of(soup(draw, 3'000, 3));
    scene.objects.push_back(object(std::make_shared<const Mesh>(bumpy_sphere(3))));  // triangles that share corners
    for (int i = 0; i < 40; ++i) scene.objects.push_back(object(Sphere{draw.in_cube(3), draw.uniform(0.05f, 0.3f)}));
    const Walked best = walked<TestType>(scene);
    CHECK(best.steps > 0);
    int tried = 0;
    with_each_instruction_set([&] {
        CHECK(walked<TestType>(scene) == best);
        ++tried;
    });
    CHECK(tried >= 1);
}

TEST_CASE("the walks of bvh8 and kd8 are compiled as exactness needs for every instruction set") {
    with_each_instruction_set([] {
        CHECK(best_bvh8_walks().faults() == CompiledFaults{});
        CHECK(best_kd8_walks().faults() == CompiledFaults{});
    });
}
