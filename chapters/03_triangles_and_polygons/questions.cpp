#include "questions.h"

#include "closed_mesh.h"
#include "exact_weights.h"
#include "judge.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/measure/quantile.h"
#include "raylab/geometry/intersect/intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

using TriangleAnswers = std::span<const std::optional<TriangleHit>>;
using PolygonAnswers = std::span<const std::optional<double>>;

std::vector<TriangleMethod> triangle_methods(const ChapterRun& run) {
    std::vector<TriangleMethod> methods = ray_triangle_methods();
    if (run.is_yours("triangle_hit")) methods.push_back(your_triangle_method());
    return methods;
}

// The oracle is the judge and takes microseconds for each query, so it is timed on a few.
Measurement timed_oracle(TriangleWorkload workload, const Truth& truth) {
    constexpr std::size_t few = 200;
    workload.queries.resize(std::min(few, workload.queries.size()));
    const Judgement right{.error = 0, .error_bound = 3e6 / static_cast<double>(truth.size())};
    return measure(exact_triangle_method(), workload, [&](TriangleAnswers) { return right; }, {.repeats = 3});
}

// How many of a million decisions the filter leaves to exact arithmetic.
double left_to_exact_arithmetic(const TriangleWorkload& workload) {
    DecisionCounts decisions;
    for (const auto& [ray, triangle] : workload.queries) intersect(ray, workload.data[triangle], decisions);
    return 1e6 * static_cast<double>(decisions.exact) / static_cast<double>(workload.queries.size());
}

}  // namespace

Experiment ray_triangle(const ChapterRun& run) {
    Experiment experiment{.question = "ray_triangle",
                          .title = "Does a ray hit a triangle?",
                          .error_axis = "wrong decisions [ppm]",
                          .rows = {}};
    for (const auto& name : ray_triangle_workload_names()) {
        const auto workload = ray_triangle_workload(name, run.sized<std::size_t>(200'000, 10'000), run.seed);
        const Truth truth = truth_of(workload, run.threads);
        const auto judge = [&](TriangleAnswers answers) { return judge_decisions(answers, truth); };
        for (const auto& method : triangle_methods(run)) {
            experiment.rows.push_back(measure(method, workload, judge, run.timing()));
            if (method.name == "filtered exact")
                experiment.rows.back().counts["left to exact [ppm]"] = left_to_exact_arithmetic(workload);
        }
        experiment.rows.push_back(timed_oracle(workload, truth));
    }
    return experiment;
}

Experiment closed_mesh(const ChapterRun& run) {
    Experiment experiment{.question = "closed_mesh",
                          .title = "Is a closed mesh closed?",
                          .error_axis = "rays that leak or hit twice [ppm]",
                          .rows = {}};
    const std::size_t count = run.sized<std::size_t>(100'000, 10'000);
    const auto add = [&](const Shots& shots) {
        const auto judge = [&](TriangleAnswers answers) {
            const Leaks leaks = count_leaks(shots, answers);
            return Judgement{.error = leaks.none + leaks.many,
                             .error_bound = 3e6 / static_cast<double>(shots.first.size() - 1),
                             .counts = {{"leaks [ppm]", leaks.none}, {"doubles [ppm]", leaks.many}}};
        };
        for (const auto& method : triangle_methods(run))
            experiment.rows.push_back(measure(method, shots.workload, judge, run.timing()));
    };
    const Mesh here = icosphere(3);
    add(shots_inside(here, {0, 0, 0}, {.target = Target::edge, .count = count, .seed = run.seed}));
    add(shots_inside(here, {0, 0, 0}, {.target = Target::vertex, .count = count, .seed = run.seed}));
    Shots far_away =
        shots_inside(moved(here, Vec3d(1000)), Vec3d(1000),
                     {.target = Target::face, .asked = Asked::all, .count = count / 100, .seed = run.seed});
    far_away.workload.name += ", mesh at 1000";
    add(far_away);
    return experiment;
}

Experiment ray_polygon(const ChapterRun& run) {
    Experiment experiment{.question = "ray_polygon",
                          .title = "Does a ray hit a polygon?",
                          .error_axis = "wrong decisions [ppm]",
                          .rows = {}};
    for (const auto& workload : polygon_workloads(run.sized<std::size_t>(20'000, 2'000), run.seed)) {
        const Truth truth = truth_of(workload, run.threads);
        const auto judge = [&](PolygonAnswers answers) { return judge_decisions(answers, truth); };
        for (const auto& method : ray_polygon_methods())
            experiment.rows.push_back(measure(method, workload, judge, run.timing()));
    }
    return experiment;
}

Experiment interpolation(const ChapterRun& run) {
    Experiment experiment{.question = "interpolation",
                          .title = "How wrong is an interpolated colour?",
                          .error_axis = "error of a weight, 99th percentile",
                          .rows = {}};
    for (const auto* name : {"generic", "sliver", "grazing", "off1e4", "far1e6"}) {
        const auto workload = ray_triangle_workload(name, run.sized<std::size_t>(20'000, 2'000), run.seed);
        std::vector<std::optional<Weights>> truth;
        for (const auto& [ray, triangle] : workload.queries)
            truth.push_back(exact_weights(ray, workload.data[triangle]));
        const auto judge = [&](TriangleAnswers answers) {
            std::vector<double> errors;
            for (std::size_t i = 0; i < answers.size(); ++i)
                if (answers[i] && truth[i])
                    errors.push_back(
                        std::max(std::abs(answers[i]->u - truth[i]->u), std::abs(answers[i]->v - truth[i]->v)));
            if (errors.empty()) return Judgement{.error = std::numeric_limits<double>::infinity()};
            std::ranges::sort(errors);
            return Judgement{.error = quantile(errors, 0.99),
                             .counts = {{"median", quantile(errors, 0.5)}, {"largest", quantile(errors, 1)}}};
        };
        for (const auto& method : triangle_methods(run))
            experiment.rows.push_back(measure(method, workload, judge, run.timing()));
    }
    return experiment;
}

}  // namespace raylab
