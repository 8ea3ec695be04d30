#include "catch.h"

#include "raylab/experiment/ray_triangle/methods.h"

#include <set>

using namespace raylab;

namespace {

std::vector<std::optional<TriangleHit>> answers(const TriangleMethod& method, const std::vector<Triangle>& triangles,
                                                const std::vector<TriangleQuery>& queries) {
    std::vector<std::optional<TriangleHit>> results(queries.size());
    const std::any state = method.prepare ? method.prepare(triangles) : std::any();
    method.answer(state, triangles, queries, results);
    return results;
}

}  // namespace

TEST_CASE("every ray-triangle method has a title of its own and names its source") {
    std::set<std::string> titles;
    for (const auto& method : ray_triangle_methods()) {
        CHECK(titles.insert(method.title()).second);
        CHECK_FALSE(method.source.empty());
    }
    CHECK(titles.contains("Moeller-Trumbore, float"));
    CHECK(titles.contains("Moeller-Trumbore, double"));
}

TEST_CASE("every ray-triangle method, and the slot, answers each query about its own triangle") {
    const std::vector<Triangle> triangles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{4, 0, 1}, {5, 0, 1}, {4, 1, 1}}};
    const Vec3f down{0, 0, -1};
    const std::vector<TriangleQuery> queries = {
        {{{4.25f, 0.5f, 2}, down}, 1}, {{{4.25f, 0.5f, 2}, down}, 0}, {{{0.25f, 0.5f, 2}, down}, 0}};
    auto methods = ray_triangle_methods();
    methods.push_back(your_triangle_method());
    for (const auto& method : methods) {
        CAPTURE(method.title());
        const auto found = answers(method, triangles, queries);
        REQUIRE(found[0]);
        CHECK(*found[0] == TriangleHit{1, 0.25, 0.5});
        CHECK_FALSE(found[1]);
        REQUIRE(found[2]);
        CHECK(*found[2] == TriangleHit{2, 0.25, 0.5});
    }
}
