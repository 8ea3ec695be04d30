#include "stability.h"
#include "trial.h"

#include <fmt/format.h>

#include <array>

namespace raylab {

namespace {}  // namespace

StabilityCase sliver(const ChapterRun& run) {
    return {"SLIVER", "Triangles 1e-5 wide, hit inside: a rounded point is a poor witness.", [run] {
                const Trial trial(ray_triangle_workload("sliver", run.sized<std::size_t>(100'000, 10'000), run.seed),
                                  run.threads);
                std::vector<CaseRow> rows;
                for (const auto* lost : {"plane and edges, float", "Badouel, float", "Baldwin-Weber, float"})
                    rows.push_back(trial.more_missed_than(0.8, lost));
                for (const auto* holds : {"Moeller-Trumbore, float", "Pluecker, float", "watertight, float"})
                    rows.push_back(trial.less_wrong_than(0.05, holds));
                rows.push_back(trial.never_wrong(filtered_exact));
                show_yours(run, trial, rows);
                return rows;
            }};
}

StabilityCase lattice(const ChapterRun& run) {
    return {
        "LATTICE",
        "Small whole numbers: hits exactly on edges and vertices, rays exactly in the plane; class by class.", [run] {
            const Trial trial(ray_triangle_workload("lattice", run.sized<std::size_t>(100'000, 10'000), run.seed),
                              run.threads);
            const auto answers = answers_of(method_called(filtered_exact), trial.workload());
            struct Class {
                oracle::HitKind hit_kind;
                std::string name;
            };
            const std::array<Class, 4> classes = {{{oracle::HitKind::miss, "misses"},
                                                   {oracle::HitKind::interior, "hits inside"},
                                                   {oracle::HitKind::boundary, "hits on the border"},
                                                   {oracle::HitKind::within, "rays in the plane"}}};
            std::vector<CaseRow> rows;
            for (const auto& [hit_kind, name] : classes) {
                std::size_t all = 0, hits = 0;
                for (std::size_t i = 0; i < answers.size(); ++i) {
                    all += trial.truth()[i].hit_kind == hit_kind;
                    hits += trial.truth()[i].hit_kind == hit_kind && answers[i].has_value();
                }
                const bool should_hit = hit_kind == oracle::HitKind::interior || hit_kind == oracle::HitKind::boundary;
                rows.push_back({std::string(filtered_exact) + ": " + name,
                                should_hit ? "holds: all hit" : "holds: none hit",
                                fmt::format("{} of {} hit", hits, all), all > 0 && hits == (should_hit ? all : 0)});
            }
            rows.push_back(trial.more_wrong_than(1e-3, "plane and edges, double"));
            rows.push_back(trial.more_wrong_than(1e-3, "Baldwin-Weber, double"));
            show_yours(run, trial, rows);
            return rows;
        }};
}

}  // namespace raylab
