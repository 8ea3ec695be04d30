#include "catch.h"

#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/geometry/quadric.h"

#include <algorithm>
#include <cmath>

using namespace raylab;

namespace {

constexpr WorkloadSize draw{.count = 2000, .seed = 1};

oracle::Answer truth(const SphereQuery& query) {
    return oracle::intersect(in<double>(query.ray), in<double>(query.sphere));
}

double share_of_hits(const SphereWorkload& workload) {
    const auto hits = std::ranges::count_if(workload.queries, [](const auto& query) { return truth(query).hit(); });
    return static_cast<double>(hits) / static_cast<double>(workload.queries.size());
}

}  // namespace

TEST_CASE("more queries to spheres begin with the fewer, and another seed gives others") {
    const auto fewer = ray_sphere_workloads({3, 1}), more = ray_sphere_workloads({5, 1}),
               other = ray_sphere_workloads({5, 2});
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        INFO(more[i].name);
        CHECK(fewer[i].queries[2].ray.direction == more[i].queries[2].ray.direction);
        CHECK(other[i].queries[2].ray.direction != more[i].queries[2].ray.direction);
    }
}

TEST_CASE("of rays that pass within 1.2 radii 1 / 1.2^2 hit, from near and from far") {
    for (const auto& workload : {generic_spheres(draw), spheres_at(1e2, draw), spheres_at(1e5, draw)}) {
        INFO(workload.name);
        CHECK_THAT(share_of_hits(workload), WithinAbs(1 / 1.44, 0.04));
    }
}

TEST_CASE("half of the rays along a silhouette hit") {
    CHECK_THAT(share_of_hits(silhouettes(draw)), WithinAbs(0.5, 0.04));
}

TEST_CASE("whole tangents touch exactly, and miss a sphere that is one float smaller") {
    for (const auto wholes : {Wholes::small, Wholes::large}) {
        const auto workload = tangents(wholes, draw);
        for (const auto& query : workload.queries) REQUIRE(truth(query).hit_kind == oracle::HitKind::tangent);
    }
    CHECK(share_of_hits(near_tangents(draw)) == 0);
}

TEST_CASE("every product of the school formula on a small whole tangent fits a float") {
    const auto workload = tangents(Wholes::small, {20000, 3});
    for (const auto& [ray, sphere] : workload.queries) {
        const Vec3d f = convert<double>(ray.origin) - convert<double>(sphere.center);
        const Vec3d d = convert<double>(ray.direction);
        const double b = dot(f, d);
        const double a_c = dot(d, d) * (dot(f, f) - double{sphere.radius} * sphere.radius);
        REQUIRE(b * b < 0x1p24);
        REQUIRE(a_c < 0x1p24);
    }
}

TEST_CASE("rays from inside a sphere and from above a floor all hit") {
    CHECK(share_of_hits(inside_starts(draw)) == 1);
    CHECK(share_of_hits(sphere_floor({.radius = 1e5}, draw)) == 1);
    CHECK(share_of_hits(sphere_floor({.radius = 1e7, .up = Up::along_y, .eye_height = 1.7}, draw)) == 1);
}

TEST_CASE("an eye stands at its height above a floor, whatever the rounding of the floor's center") {
    const auto workload = sphere_floor({.radius = 1e7, .eye_height = 1.5}, draw);
    for (const auto& [ray, sphere] : workload.queries) {
        const double from_center = glm::length(convert<double>(ray.origin) - convert<double>(sphere.center));
        REQUIRE_THAT(from_center - double{sphere.radius}, WithinAbs(1.5, 1e-4));
    }
}

TEST_CASE("a ray that leaves a surface starts inside or outside by chance") {
    CHECK_THAT(share_of_hits(surface_starts(draw)), WithinAbs(0.5, 0.04));
}
