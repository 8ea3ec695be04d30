#include "raylab/report/structure/structure_growth.h"

#include "catch.h"

using namespace raylab;

namespace {

constexpr MeasureOptions quick{.repeats = 1, .shortest = 0};

const StructureCost& cost(const std::vector<StructureCost>& costs, const std::string& structure,
                          std::size_t primitives) {
    for (const auto& one : costs)
        if (one.structure == structure && one.primitives == primitives) return one;
    throw std::runtime_error("no " + structure);
}

}  // namespace

TEST_CASE("a list's tests grow as the scene does, a tree's hardly") {
    const std::vector<GrowingScenes> families{bumpy_balls(2, 400)};
    const auto costs = structure_costs(structure_methods({"list", "bvh"}), families, 1e6, quick);
    REQUIRE(costs.size() == 4);
    CHECK(cost(costs, "list", 320).primitive_tests == 320);
    CHECK(cost(costs, "list", 1280).primitive_tests == 1280);
    CHECK(cost(costs, "bvh", 1280).primitive_tests < 2 * cost(costs, "bvh", 320).primitive_tests);
    for (const auto& one : costs) {
        CHECK(one.build_seconds > 0);
        CHECK(one.bytes > 10);
        CHECK(one.nanoseconds.median > 0);
    }
}

TEST_CASE("where rays are dear there are fewer of them, and the same ones every time") {
    const std::vector<GrowingScenes> families{bumpy_balls(1, 900)};
    const auto once = structure_costs(structure_methods({"list"}), families, 32'000, quick);
    CHECK(once.front().rays == 100);
    CHECK(structure_costs(structure_methods({"list"}), families, 1e9, quick).front().rays == 900);
    CHECK(structure_costs(structure_methods({"bvh"}), families, 32'000, quick).front().box_tests ==
          structure_costs(structure_methods({"bvh"}), families, 32'000, quick).front().box_tests);
}

TEST_CASE("a growth chart has a curve for each structure and family, over primitives") {
    const std::vector<StructureCost> costs{
        {.structure = "a", .family = "x", .primitives = 10, .nanoseconds = {100, 50, 200}, .steps = 3},
        {.structure = "a", .family = "x", .primitives = 20, .nanoseconds = {200, 100, 400}, .steps = 4},
        {.structure = "b", .family = "x", .primitives = 10, .nanoseconds = {100, 100, 100}}};
    const auto rays = growth_chart(costs, GrowthOf::rays_per_second);
    REQUIRE(rays.curves.size() == 2);
    CHECK(rays.curves[0].x == std::vector<double>{10, 20});
    CHECK(rays.curves[0].y == std::vector<double>{1e7, 5e6});
    CHECK(rays.curves[0].low == std::vector<double>{5e6, 2.5e6});
    const auto steps = growth_chart(costs, GrowthOf::steps);
    REQUIRE(steps.curves.size() == 1);  // b has no steps
    CHECK(steps.curves[0].low.empty());
}
