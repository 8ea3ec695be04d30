#include "catch.h"

#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"
#include "raylab/geometry/oracle/oracle.h"

using namespace raylab;

namespace {

constexpr std::size_t pairs = 1000;

std::vector<std::optional<TriangleHit>> answers(const TriangleMethod& method, const TriangleWorkload& workload) {
    std::vector<std::optional<TriangleHit>> results(workload.queries.size());
    const std::any state = method.prepare ? method.prepare(workload.data) : std::any();
    method.answer(state, workload.data, workload.queries, results);
    return results;
}

}  // namespace

TEST_CASE("on generic pairs every method decides as the oracle does, and its t is the oracle's") {
    const auto workload = ray_triangle_workload("generic", pairs, 1);
    const auto truth = answers(exact_triangle_method(), workload);
    auto methods = ray_triangle_methods();
    methods.push_back(your_triangle_method());
    for (const auto& method : methods) {
        CAPTURE(method.title());
        const double relative = method.number == "float" ? 1e-3 : 1e-11;  // few generic rays see their triangle edge-on
        const auto found = answers(method, workload);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            CAPTURE(i);
            REQUIRE(found[i].has_value() == truth[i].has_value());
            if (truth[i]) CHECK_THAT(found[i]->t, WithinRel(truth[i]->t, relative));
        }
    }
}

TEST_CASE("filtered exact decides as the oracle does on every workload") {
    const auto filtered = find_method(ray_triangle_methods(), "filtered exact, double + exact");
    for (const auto& name : ray_triangle_workload_names()) {
        CAPTURE(name);
        const auto workload = ray_triangle_workload(name, pairs, 2);
        const auto truth = answers(exact_triangle_method(), workload);
        const auto found = answers(filtered, workload);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) wrong += found[i].has_value() != truth[i].has_value();
        CHECK(wrong == 0);
    }
}

TEST_CASE("u and v are the weights of b and c: with t they name one point") {
    const auto workload = ray_triangle_workload("generic", pairs, 3);
    for (const auto& method : ray_triangle_methods()) {
        if (method.number == "float") continue;
        CAPTURE(method.title());
        const auto found = answers(method, workload);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (!found[i]) continue;
            const auto& [t, u, v] = *found[i];
            const auto ray = in<double>(workload.queries[i].ray);
            const auto [a, b, c] = in<double>(workload.data[i]);
            const Vec3d on_ray = ray.origin + t * ray.direction;
            CHECK(glm::length(on_ray - (a + u * (b - a) + v * (c - a))) < 1e-9);
        }
    }
}
