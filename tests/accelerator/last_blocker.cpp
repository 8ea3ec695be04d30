#include "catch.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;
using namespace raylab::adversarial;

TEST_CASE("what stopped a light's last ray is asked first about the next one") {
    const Scene scene = scene_of(floor_of(20));  // y = 1
    const Ray stopped{{7.25f, 3, 6.5f}, {0, -1, 0}}, beside{{7.25f, 3, 6.5f}, {1, 0, 0}};
    for (const char* name : {"bvh", "bvh8", "bvh8_splits", "grid", "grid_mailbox", "octree", "octree_point",
                             "octree_hash", "octree_seads", "kd", "kd8", "bsp"}) {
        INFO(name);
        const auto structure = make_accelerator(name, scene);
        Traversal traversal;
        traversal.toward(0);
        const auto tests_and_steps = [&](const Ray& ray, bool is_stopped) {
            const TestCounts before = traversal;
            CHECK(structure->occluded(ray, traversal) == is_stopped);
            return std::pair{traversal.primitive_tests - before.primitive_tests, traversal.steps - before.steps};
        };
        const auto [tests, steps] = tests_and_steps(stopped, true);
        CHECK((tests > 0 && steps > 0));
        CHECK(tests_and_steps(stopped, true) == std::pair{std::uint64_t{1}, std::uint64_t{0}});
        CHECK(tests_and_steps(beside, false).first >= 1);
        CHECK(tests_and_steps(stopped, true).second > 0);  // it is forgotten
    }
}
