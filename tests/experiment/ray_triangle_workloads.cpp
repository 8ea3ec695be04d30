#include "catch.h"

#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"
#include "raylab/geometry/oracle/oracle.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr std::size_t pairs = 4000;

/// The share of pairs for which the oracle's answer is one of `wanted`.
double share(const TriangleWorkload& workload, std::initializer_list<oracle::HitKind> wanted) {
    std::size_t count = 0;
    for (const auto& [ray, triangle] : workload.queries) {
        const auto answer = oracle::intersect(in<double>(ray), in<double>(workload.data[triangle]));
        count += std::ranges::count(wanted, answer.hit_kind);
    }
    return static_cast<double>(count) / static_cast<double>(workload.queries.size());
}

constexpr auto interior = oracle::HitKind::interior, boundary = oracle::HitKind::boundary;

}  // namespace

TEST_CASE("a longer workload starts with the shorter one, and another seed gives another") {
    for (const auto& name : ray_triangle_workload_names()) {
        CAPTURE(name);
        const auto shorter = ray_triangle_workload(name, 10, 1), longer = ray_triangle_workload(name, 20, 1);
        const auto other = ray_triangle_workload(name, 10, 2);
        CHECK(shorter.data[9].b == longer.data[9].b);
        CHECK(shorter.queries[9].ray.direction == longer.queries[9].ray.direction);
        CHECK(shorter.queries[9].ray.direction != other.queries[9].ray.direction);
    }
}

TEST_CASE("a generic pair is a hit every other time, exactly on the border never") {
    const auto workload = ray_triangle_workload("generic", pairs, 1);
    CHECK_THAT(share(workload, {interior}), WithinAbs(0.5, 0.03));
    CHECK(share(workload, {boundary}) == 0);
}

TEST_CASE("a ray aimed at an edge, rounded, passes it on either side, but hardly ever exactly through it") {
    const auto workload = ray_triangle_workload("edge", pairs, 1);
    CHECK_THAT(share(workload, {interior}), WithinAbs(0.5, 0.03));
    CHECK(share(workload, {boundary}) < 0.001);
}

TEST_CASE("one ray in twenty aimed at a vertex goes exactly through it") {
    CHECK_THAT(share(ray_triangle_workload("vertex", pairs, 1), {boundary}), WithinAbs(0.05, 0.02));
}

TEST_CASE("almost every ray aimed into a sliver, a tiny or a huge triangle, or grazing one, hits it") {
    for (const auto* name : {"sliver", "grazing", "tiny1e-15", "huge1e13"}) {
        CAPTURE(name);
        CHECK(share(ray_triangle_workload(name, pairs, 1), {interior, boundary}) > 0.85);
    }
}

TEST_CASE("most hits of the lattice are exactly on the border, and some of its rays lie in the plane") {
    const auto workload = ray_triangle_workload("lattice", pairs, 1);
    CHECK(share(workload, {boundary}) > share(workload, {interior}));
    CHECK(share(workload, {oracle::HitKind::within}) > 0.01);
}
