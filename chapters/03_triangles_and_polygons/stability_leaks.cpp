#include "stability.h"
#include "trial.h"

#include "raylab/experiment/generate/generate.h"

namespace raylab {

namespace {

LeakTrial shots_at(Target target, const ChapterRun& run) {
    return LeakTrial(
        shots_inside(icosphere(3), {0, 0, 0},
                     {.target = target, .count = run.sized<std::size_t>(100'000, 10'000), .seed = run.seed}));
}

}  // namespace

StabilityCase edge_shot(const ChapterRun& run) {
    return {"EDGE-SHOT",
            "Rays from inside a closed mesh of 1280 triangles, aimed at its shared edges: each hits one triangle.",
            [run] {
                const LeakTrial trial = shots_at(Target::edge, run);
                std::vector<CaseRow> rows;
                for (const auto* leaky :
                     {"plane and edges, float", "Badouel, float", "Moeller-Trumbore, float", "Baldwin-Weber, float"})
                    rows.push_back(trial.leaks_more_than(0.01, leaky));
                for (const auto* tight : {"Pluecker, float", "watertight, float"})
                    rows.push_back(trial.never_leaks(tight));
                for (const auto* sure : {"Moeller-Trumbore, double", filtered_exact})
                    rows.push_back(trial.always_one_hit(sure));
                show_yours(run, trial, rows);
                return rows;
            }};
}

StabilityCase vertex_shot(const ChapterRun& run) {
    return {"VERTEX-SHOT", "The same rays aimed at the vertices, where five or six triangles meet.", [run] {
                const LeakTrial trial = shots_at(Target::vertex, run);
                std::vector<CaseRow> rows = {trial.leaks_more_than(100e-6, "Pluecker, float"),
                                             trial.doubles_more_than(0.1, "watertight, float"),
                                             trial.never_leaks(filtered_exact)};
                const auto exact = Trial(trial.shots().workload, run.threads);
                rows.push_back(exact.never_wrong(filtered_exact));
                show_yours(run, trial, rows);
                return rows;
            }};
}

}  // namespace raylab
