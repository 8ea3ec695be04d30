#include "stability.h"
#include "trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

std::size_t pairs(const ChapterRun& run) { return run.sized<std::size_t>(100'000, 10'000); }

Trial trial_on(const std::string& name, const ChapterRun& run) {
    return Trial(ray_triangle_workload(name, pairs(run), run.seed), run.threads);
}

Vec3f scaled(const Vec3f& v, int exponent) { return v * std::ldexp(1.0f, exponent); }

/// The same pairs in another unit of length: it is a power of two, so nothing is rounded.
TriangleWorkload scaled(TriangleWorkload workload, int exponent) {
    workload.name += fmt::format(" x 2^{}", exponent);
    for (auto& [a, b, c] : workload.data) {
        a = scaled(a, exponent);
        b = scaled(b, exponent);
        c = scaled(c, exponent);
    }
    for (auto& [ray, triangle] : workload.queries) {
        ray.origin = scaled(ray.origin, exponent);
        ray.direction = scaled(ray.direction, exponent);
    }
    return workload;
}

std::vector<bool> decisions(const TriangleMethod& method, const TriangleWorkload& workload) {
    std::vector<bool> hits;
    for (const auto& answer : answers_of(method, workload)) hits.push_back(answer.has_value());
    return hits;
}

CaseRow same_in_another_unit(const std::string& title, const TriangleWorkload& workload) {
    const auto method = method_called(title);
    const auto here = decisions(method, workload);
    std::size_t changed = 0;
    for (const int exponent : {-20, 20}) {
        const auto there = decisions(method, scaled(workload, exponent));
        for (std::size_t i = 0; i < here.size(); ++i) changed += here[i] != there[i];
    }
    return {title + ": " + workload.name + " x 2^-20, 2^20", "holds: the same decisions, bit by bit",
            fmt::format("{} decisions changed", changed), changed == 0};
}

CaseRow no_hit_without_numbers(const std::string& title, const TriangleWorkload& workload) {
    std::size_t hits = 0, strange = 0;
    for (const auto& answer : answers_of(method_called(title), workload)) {
        if (!answer) continue;
        ++hits;
        strange += !(std::isfinite(answer->t) && std::isfinite(answer->u) && std::isfinite(answer->v));
    }
    return {title + ": " + workload.name, "holds: whatever it hits has finite t, u, v",
            fmt::format("{} hits, {} of them not finite", hits, strange), strange == 0};
}

}  // namespace

StabilityCase det_eps(const ChapterRun& run) {
    return {"DET-EPS", "The absolute epsilon that takes small or grazing triangles for parallel ones.", [run] {
                const TriangleWorkload generic = ray_triangle_workload("edge", pairs(run), run.seed);
                const Trial small(scaled(ray_triangle_workload("generic", pairs(run), run.seed), -40), run.threads);
                const Trial grazing = trial_on("grazing", run);
                std::vector<CaseRow> rows;
                for (const auto* number : {"float", "double"}) {
                    const auto eps = std::string("Moeller-Trumbore, eps 1e-8, ") + number;
                    const auto wrong = small.wrong(eps);
                    const auto hits = 1e6 *
                                      static_cast<double>(std::ranges::count_if(small.truth(), &oracle::Answer::hit)) /
                                      static_cast<double>(small.truth().size());
                    rows.push_back({eps + ": " + small.workload().name, "fails: misses all it should hit",
                                    in_words(wrong), wrong.misses > 0.999 * hits});
                }
                rows.push_back(small.never_wrong("Moeller-Trumbore, double"));
                rows.push_back(grazing.more_missed_than(0.7, "Moeller-Trumbore, eps 1e-5, float"));
                rows.push_back(grazing.less_wrong_than(0.2, "Moeller-Trumbore, float"));
                for (const auto* title : {"Moeller-Trumbore, float", "Pluecker, float", "watertight, float",
                                          "plane and edges, float", "Baldwin-Weber, float", filtered_exact})
                    rows.push_back(same_in_another_unit(title, generic));
                show_yours(run, small, rows);
                return rows;
            }};
}

StabilityCase far_scene(const ChapterRun& run) {
    return {"FAR-SCENE", "The scene 10 000 from the world's origin, and the eye a million from the scene.", [run] {
                const Trial moved = trial_on("off1e4", run), seen_from_afar = trial_on("far1e6", run);
                std::vector<CaseRow> rows;
                for (const auto* collapses : {"Pluecker, world, float", "Baldwin-Weber, float"})
                    rows.push_back(moved.more_wrong_than(0.4, collapses));
                for (const auto* holds : {"Moeller-Trumbore, float", "Pluecker, float", "watertight, float"})
                    rows.push_back(moved.less_wrong_than(0.003, holds));
                rows.push_back(moved.never_wrong(filtered_exact));
                for (const auto* wrong : {"Moeller-Trumbore, float", "Pluecker, float"})
                    rows.push_back(seen_from_afar.more_wrong_than(0.05, wrong));
                rows.push_back(seen_from_afar.never_wrong(filtered_exact));
                show_yours(run, seen_from_afar, rows);
                return rows;
            }};
}

StabilityCase range(const ChapterRun& run) {
    return {"RANGE", "Scenes so small or so large that products of floats leave the range of a float.", [run] {
                const Trial small = trial_on("tiny1e-15", run), large = trial_on("huge1e13", run);
                std::vector<CaseRow> rows;
                for (const Trial* trial : {&small, &large}) {
                    for (const auto* lost : {"plane and edges, float", "Badouel, float", "Moeller-Trumbore, float",
                                             "Pluecker, float", "Baldwin-Weber, float"}) {
                        rows.push_back(trial->more_missed_than(0.2, lost));
                        rows.push_back(no_hit_without_numbers(lost, trial->workload()));
                    }
                    for (const auto* holds : {"Moeller-Trumbore, double", "Pluecker, double", filtered_exact})
                        rows.push_back(trial->never_wrong(holds));
                    show_yours(run, *trial, rows);
                }
                return rows;
            }};
}

}  // namespace raylab
