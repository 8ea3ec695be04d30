#include "questions.h"

#include "judge.h"

namespace raylab::transforms {

Experiment measure_placed_sphere(const ChapterRun& run) {
    Experiment experiment{.question = "placed_sphere",
                          .title = "Where does a ray hit a placed sphere?",
                          .error_axis = "wrong decisions [ppm]"};
    const auto methods = placed_sphere_methods();
    for (const auto& workload : sphere_workloads(run.sized<std::size_t>(20'000, 1'000), run.seed)) {
        const auto truths = truth(workload, run.threads);
        for (const auto& method : methods)
            experiment.rows.push_back(measure(
                method, workload,
                [&](std::span<const std::optional<double>> answers) { return judge_hits(truths, answers); },
                run.timing()));
    }
    return experiment;
}

Experiment measure_transformed_normal(const ChapterRun& run) {
    Experiment experiment{.question = "transformed_normal",
                          .title = "What is the normal of a placed surface?",
                          .error_axis = "worst angle to the true normal [rad]"};
    auto methods = normal_methods();
    if (run.is_yours("transformed_normal")) methods.push_back(your_normal_method());
    for (const auto& workload : normal_workloads(run.sized<std::size_t>(20'000, 2'000), run.seed)) {
        const auto truths = truth(workload);
        for (const auto& method : methods)
            experiment.rows.push_back(measure(
                method, workload, [&](std::span<const Vec3d> answers) { return judge_normals(truths, answers); },
                run.timing()));
    }
    return experiment;
}

}  // namespace raylab::transforms
