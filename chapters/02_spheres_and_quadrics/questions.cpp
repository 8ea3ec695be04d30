#include "questions.h"

#include "judge.h"

#include "raylab/geometry/intersect/intersect.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace raylab {

namespace {

using Given = std::span<const std::optional<double>>;

// All methods on one workload, in a row each: judge(answers, truth, method) compares them with the truth.
template <class Data, class Query, class Judge>
std::vector<Measurement> measured(const std::vector<Method<Data, Query, std::optional<double>>>& methods,
                                  const Workload<Data, Query>& workload, const ChapterRun& run, const Judge& judge) {
    const Truth truth = truth_of(workload, run.threads);
    std::vector<Measurement> rows;
    for (const auto& method : methods)
        rows.push_back(measure(
            method, workload, [&](Given answers) { return judge(answers, truth, method); }, run.timing()));
    return rows;
}

constexpr auto by_decisions = [](Given answers, const Truth& truth, const auto&) {
    return judge_decisions(answers, truth);
};
constexpr auto by_t = [](Given answers, const Truth& truth, const auto& method) {
    return judge_t(answers, truth, method.number);
};

// The oracle is the judge, and takes microseconds for each query, so it is timed on a few.
constexpr std::size_t oracle_queries = 200;

template <class Data, class Query>
Measurement timed_oracle(const Method<Data, Query, std::optional<double>>& oracle, Workload<Data, Query> workload) {
    const Judgement right{.error = 0, .error_bound = 3e6 / static_cast<double>(workload.queries.size())};
    workload.queries.resize(std::min(oracle_queries, workload.queries.size()));
    return measure(oracle, workload, [&](Given) { return right; }, {.repeats = 3});
}

std::vector<SphereMethod> sphere_methods(const ChapterRun& run) {
    std::vector<SphereMethod> methods = ray_sphere_methods();
    if (run.is_yours("nearest_sphere_hit")) methods.push_back(your_sphere_method());
    return methods;
}

// How many of a million decisions the filter leaves to exact arithmetic.
double left_to_exact_arithmetic(const SphereWorkload& workload) {
    DecisionCounts decisions;
    for (const auto& [ray, sphere] : workload.queries) intersect(ray, sphere, decisions);
    return 1e6 * static_cast<double>(decisions.exact) / static_cast<double>(workload.queries.size());
}

}  // namespace

Experiment ray_sphere(const ChapterRun& run) {
    Experiment experiment{.question = "ray_sphere",
                          .title = "Does a ray hit a sphere?",
                          .error_axis = "wrong decisions [ppm]",
                          .rows = {}};
    const WorkloadSize draw{run.sized<std::size_t>(50'000, 3'000), run.seed};
    for (const SphereWorkload& workload : {generic_spheres(draw), spheres_at(1e2, draw), spheres_at(4096, draw),
                                           spheres_at(1e5, draw), silhouettes(draw), tangents(Wholes::large, draw)}) {
        for (Measurement& row : measured(sphere_methods(run), workload, run, by_decisions)) {
            if (row.method == "filtered exact") row.counts["left to exact [ppm]"] = left_to_exact_arithmetic(workload);
            experiment.rows.push_back(std::move(row));
        }
        experiment.rows.push_back(timed_oracle(exact_sphere_method(), workload));
    }
    return experiment;
}

Experiment ray_sphere_t(const ChapterRun& run) {
    Experiment experiment{.question = "ray_sphere_t",
                          .title = "Where does a ray hit a sphere?",
                          .error_axis = "error of t, 99th percentile [ulp of a float]",
                          .rows = {}};
    const WorkloadSize draw{run.sized<std::size_t>(5'000, 500), run.seed};
    for (const SphereWorkload& workload :
         {generic_spheres(draw), spheres_at(1e2, draw), inside_starts(draw), sphere_floor({.radius = 1e5}, draw),
          sphere_floor({.radius = 1e7}, draw), sphere_floor({.radius = 1e7, .up = Up::along_y}, draw)})
        std::ranges::move(measured(sphere_methods(run), workload, run, by_t), std::back_inserter(experiment.rows));
    return experiment;
}

Experiment ray_quadric(const ChapterRun& run) {
    Experiment experiment{.question = "ray_quadric",
                          .title = "Does a ray hit a quadric?",
                          .error_axis = "wrong decisions [ppm]",
                          .rows = {}};
    const WorkloadSize draw{run.sized<std::size_t>(20'000, 1'000), run.seed};
    const std::vector<QuadricWorkload> workloads = {quadrics_at(4, QuadricKind::any, draw),
                                                    quadrics_at(1000, QuadricKind::any, draw), grazing_quadrics(draw),
                                                    rims(draw)};
    for (const QuadricWorkload& workload : workloads) {
        std::ranges::move(measured(ray_quadric_methods(), workload, run, by_decisions),
                          std::back_inserter(experiment.rows));
        experiment.rows.push_back(timed_oracle(exact_quadric_method(), workload));
    }
    return experiment;
}

}  // namespace raylab
