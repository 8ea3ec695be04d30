#include "questions.h"

#include "highlights.h"
#include "shaded_mesh.h"

#include "raylab/report/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::lighting {

namespace {

// The root mean square, which an eye would notice, and the worst error; both are infinite where there is a NaN.
Judgement judge(std::span<const double> truth, std::span<const double> answers) {
    double squares = 0, worst = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = std::isnan(answers[i]) ? INFINITY : std::abs(answers[i] - truth[i]);
        squares += error * error;
        worst = std::max(worst, error);
    }
    return {.error = std::sqrt(squares / static_cast<double>(truth.size())), .counts = {{"worst error", worst}}};
}

}  // namespace

Experiment measure_mesh_shading(const ChapterRun& run) {
    Experiment experiment{.question = "mesh_shading",
                          .title = "How bright is a point of a mesh?",
                          .error_axis = "root mean square of the brightness off the exact surface's",
                          .answer = answer_within(0.01)};
    auto methods = shading_methods();
    methods.push_back(shading_at_a_hit(run.name_of("gouraud_and_phong", "Phong, textbook")));
    const int finest = run.sized(6, 4);
    for (const auto& surface : smooth_surfaces()) {
        const auto places = seen_places(surface, run.sized<std::size_t>(20'000, 2'000), run.seed);
        const auto truths = truth(surface, places);
        for (int level = 1; level <= finest; ++level) {
            const auto points = workload(surface, level, places);
            for (const auto& method : methods) {
                auto row = measure(
                    method, points, [&](std::span<const double> answers) { return judge(truths, answers); },
                    run.timing());
                row.knob = fmt::format("{} triangles", points.data[0].mesh.faces.size());
                row.counts["triangles"] = static_cast<double>(points.data[0].mesh.faces.size());
                experiment.rows.push_back(row);
            }
        }
    }
    return experiment;
}

Experiment measure_phong_specular(const ChapterRun& run) {
    Experiment experiment{.question = "phong_specular",
                          .title = "How bright is a highlight?",
                          .error_axis = "root mean square of the brightness off Phong's"};
    auto methods = highlight_methods();
    if (run.is_yours("phong_specular")) methods.push_back(your_highlight_method());
    for (const auto& points : highlight_workloads(run.sized<std::size_t>(20'000, 2'000), run.seed)) {
        std::vector<double> truths;
        for (const auto& query : points.queries) truths.push_back(true_highlight(query));
        for (const auto& method : methods)
            experiment.rows.push_back(measure(
                method, points, [&](std::span<const double> answers) { return judge(truths, answers); }, run.timing()));
    }
    return experiment;
}

}  // namespace raylab::lighting
