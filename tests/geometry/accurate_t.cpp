#include "catch.h"

#include "geometry/verdict.h"
#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"
#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"
#include "raylab/geometry/filter/triangle_from_vertex.h"
#include "raylab/geometry/predicate/triangle_intersection.h"

using namespace raylab;

namespace {

constexpr std::size_t pairs = 5'000;

/// The accuracy of the answers to a workload.
struct Worth {
    std::uint64_t exact = 0;  // left to exact arithmetic
    std::size_t hits = 0, outside = 0;
    double t_ulp = 0;         // the worst error of t rounded to float
    double t_error = 0;       // the worst promised error of t, relative
    double weight_error = 0;  // the worst error of u and v

    void add(const Candidate& candidate, const oracle::ExactT& truth) {
        ++hits;
        outside += is_gt(truth.compare(candidate.t + candidate.t_error)) ||
                   is_lt(truth.compare(candidate.t - candidate.t_error));
        t_ulp = std::max(t_ulp, truth.error_in_ulp(cast<float>(candidate.t)));
        t_error = std::max(t_error, candidate.t_error / std::abs(candidate.t));
    }
};

double weight_error(const Ray& ray, const Triangle& triangle, const Candidate& given) {
    Signs<Dyadic> signs;
    const auto exact = crossing(transformed_ray<Dyadic>(ray, {}), triangle, Sides::both, signs).value();
    return std::max(std::abs(given.u - quotient(exact.v, exact.determinant())),
                    std::abs(given.v - quotient(exact.w, exact.determinant())));
}

Worth worth_on(const TriangleWorkload& workload) {
    Worth worth;
    DecisionCounts decisions;
    for (const auto& [ray, index] : workload.queries) {
        const Triangle& triangle = workload.data[index];
        const auto candidate = intersect(ray, triangle, decisions);
        const auto truth = oracle::intersect(in<double>(ray), in<double>(triangle));
        REQUIRE(candidate.has_value() == truth.hit());
        if (!candidate) continue;
        worth.add(*candidate, *truth.t);
        worth.weight_error = std::max(worth.weight_error, weight_error(ray, triangle, *candidate));
    }
    worth.exact = decisions.exact;
    return worth;
}

Worth worth_on(const SphereWorkload& workload) {
    Worth worth;
    DecisionCounts decisions;
    for (const auto& [ray, sphere] : workload.queries) {
        const auto candidate = intersect(ray, sphere, decisions);
        const auto truth =
            oracle::intersect(in<double>(ray), SphereOf<double>{convert<double>(sphere.center), sphere.radius});
        REQUIRE(candidate.has_value() == truth.hit());
        if (candidate) worth.add(*candidate, *truth.t);
    }
    worth.exact = decisions.exact;
    return worth;
}

}  // namespace

TEST_CASE("a triangle that is hit for sure gets an accurate t and accurate weights without exact arithmetic") {
    for (const auto* name : {"generic", "sliver", "grazing", "off1e4", "far1e6", "tiny1e-15", "huge1e13"}) {
        CAPTURE(name);
        const Worth worth = worth_on(ray_triangle_workload(name, adversarial::watched(pairs), 5));
        CHECK(worth.exact == 0);
        CHECK(worth.hits > 20);
        CHECK(worth.outside == 0);
        CHECK(worth.t_ulp <= 0.75);
        CHECK(worth.t_error <= t_accuracy);
        CHECK(worth.weight_error <= 2 * t_accuracy);
    }
}

TEST_CASE(
    "seen from a vertex, in doubles, a hit far away, on a sliver or at a grazing angle is accurate, in nine of ten "
    "cases") {
    for (const auto* name : {"sliver", "grazing", "far1e6", "tiny1e-15", "huge1e13"}) {
        CAPTURE(name);
        const auto workload = ray_triangle_workload(name, adversarial::watched(pairs), 6);
        Worth worth;
        std::size_t hits = 0;
        for (const auto& [ray, index] : workload.queries) {
            const Triangle& triangle = workload.data[index];
            const auto truth = oracle::intersect(in<double>(ray), in<double>(triangle));
            hits += truth.hit();
            const auto candidate = truth.hit() ? hit_from_vertex(ray, triangle) : std::nullopt;
            if (!candidate) continue;
            worth.add(*candidate, *truth.t);
            worth.weight_error = std::max(worth.weight_error, weight_error(ray, triangle, *candidate));
        }
        CHECK(10 * worth.hits >= 9 * hits);
        CHECK(worth.outside == 0);
        CHECK(worth.t_ulp <= 0.75);
        CHECK(worth.t_error <= t_accuracy);
        CHECK(worth.weight_error <= t_accuracy);
    }
}

TEST_CASE("a sphere that is hit for sure gets an accurate t without exact arithmetic") {
    const WorkloadSize draw{adversarial::watched(pairs), 5};
    for (const auto& workload :
         {generic_spheres(draw), spheres_at(1e5, draw), spheres_at(1e7, draw), silhouettes(draw), inside_starts(draw),
          surface_starts(draw), sphere_floor({.radius = 1e7}, draw), tangents(Wholes::small, draw)}) {
        CAPTURE(workload.name);
        const Worth worth = worth_on(workload);
        CHECK(worth.exact == 0);
        CHECK(worth.hits > 20);
        CHECK(worth.outside == 0);
        CHECK(worth.t_ulp <= 0.75);
        CHECK(worth.t_error <= t_accuracy);
    }
}
