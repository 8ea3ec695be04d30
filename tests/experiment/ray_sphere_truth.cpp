#include "catch.h"

#include "raylab/experiment/ray_quadric/ray_quadric_workloads.h"
#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"
#include "raylab/geometry/oracle/oracle.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr WorkloadSize draw{.count = 1500, .seed = 20};

template <class Data, class Query>
std::vector<std::optional<double>> answers(const Method<Data, Query, std::optional<double>>& method,
                                           const Workload<Data, Query>& workload) {
    std::vector<std::optional<double>> answers(workload.queries.size());
    const std::any state = method.prepare ? method.prepare(workload.data) : std::any{};
    method.answer(state, workload.data, workload.queries, answers);
    return answers;
}

// How many answers differ from the exact ones in hit or miss, or in t by more than the relative `tolerance`.
template <class Data, class Query>
int differing(const Method<Data, Query, std::optional<double>>& method, const Workload<Data, Query>& workload,
              const std::vector<std::optional<double>>& exact, double tolerance) {
    const auto given = answers(method, workload);
    int count = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        if (given[i].has_value() != exact[i].has_value() ||
            (exact[i] && !(std::abs(*given[i] - *exact[i]) <= tolerance * std::abs(*exact[i]))))
            ++count;
    return count;
}

}  // namespace

TEST_CASE("on generic spheres every method agrees with the oracle, to its number's precision") {
    const SphereWorkload generic = generic_spheres(draw);
    const auto exact = answers(exact_sphere_method(), generic);
    for (const SphereMethod& method : ray_sphere_methods()) {
        INFO(method.title());
        CHECK(differing(method, generic, exact, method.number == "float" ? 1e-4 : 1e-12) == 0);
    }
    CHECK(differing(your_sphere_method(), generic, exact, 1e-12) == 0);
}

TEST_CASE("the lab's own method decides every ray-sphere workload as the oracle does, t to a float's last place") {
    const SphereMethod filtered = find_method(ray_sphere_methods(), "filtered exact, double + exact");
    for (const SphereWorkload& workload : ray_sphere_workloads(draw)) {
        INFO(workload.name);
        CHECK(differing(filtered, workload, answers(exact_sphere_method(), workload), 0x1p-24) == 0);
    }
}

TEST_CASE("on generic quadrics the general method agrees with the oracle in every number") {
    for (const auto kind : {QuadricKind::ellipsoid, QuadricKind::cylinder, QuadricKind::cone, QuadricKind::paraboloid,
                            QuadricKind::hyperboloid}) {
        const QuadricWorkload workload = quadrics_at(4, kind, draw);
        const auto exact = answers(exact_quadric_method(), workload);
        INFO(workload.name);
        for (const QuadricMethod& method : ray_quadric_methods()) {
            INFO(method.title());
            CHECK(differing(method, workload, exact, method.number == "float" ? 1e-3 : 1e-11) == 0);
        }
    }
}

TEST_CASE("the lab's own method decides rims, apexes and grazing rays of quadrics as the oracle does") {
    const QuadricMethod filtered = find_method(ray_quadric_methods(), "filtered exact, double + exact");
    for (const QuadricWorkload& workload : {rims(draw), apexes(draw), grazing_quadrics(draw)}) {
        INFO(workload.name);
        CHECK(differing(filtered, workload, answers(exact_quadric_method(), workload), 0x1p-24) == 0);
    }
}
