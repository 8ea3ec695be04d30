#include "catch.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// So many stacks of eight triangles across the x axis, each of which fits into a leaf, one behind the other.
std::vector<Triangle> stacks_along_x(std::size_t count) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < 8 * count; ++i) {
        const auto x = static_cast<float>(100 * (i / 8) + i % 8);
        triangles.push_back({{x, -2, -2}, {x, 3, -2}, {x, -2, 3}});
    }
    return triangles;
}

}  // namespace

// The answer would be the same in any order, only later.
TEST_CASE("of the children that a ray hits the nearest is visited first, and then no other") {
    for (std::size_t stacks = 2; stacks <= 8; ++stacks)
        for (const char* name : {"bvh8", "bvh8_splits"}) {
            INFO(stacks << " stacks, " << name);
            const auto structure = make_accelerator(name, scene_of(stacks_along_x(stacks)));
            for (const Ray& ray : {Ray{{-10, 0, 0}, {1, 0, 0}}, Ray{{1000, 0, 0}, {-1, 0, 0}}}) {
                Traversal traversal;
                const auto hit = structure->closest(ray, traversal);
                REQUIRE(hit);
                CHECK(hit->primitive.part == (ray.direction.x > 0 ? 0 : 8 * stacks - 1));
                CHECK(traversal.steps == 1);
                CHECK(traversal.primitive_tests == 8);
            }
        }
}
