#include "fma/shot_file.h"
#include "stability.h"
#include "trial.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"
#include "raylab/experiment/generate/generate.h"

#include <fmt/format.h>

#include <csignal>
#include <sstream>

namespace raylab {

namespace {

const std::filesystem::path program =
    std::filesystem::path(RAYLAB_BUILD) / "chapters/03_triangles_and_polygons/fma_shots";

ShotFile as_file(const Shots& shots) {
    ShotFile file{.triangles = shots.workload.data, .origins = {}, .directions = {}, .first = {}, .asked = {}};
    for (std::size_t i = 0; i + 1 < shots.first.size(); ++i) {
        const Ray& ray = shots.workload.queries[shots.first[i]].ray;
        file.origins.push_back(ray.origin);
        file.directions.push_back(ray.direction);
    }
    for (const auto first : shots.first) file.first.push_back(static_cast<std::uint32_t>(first));
    for (const auto& query : shots.workload.queries) file.asked.push_back(query.triangle);
    return file;
}

struct FusedLeaks {
    std::string method;
    Leaks leaks;
    std::optional<std::size_t> first;  // the first ray that leaks
};

std::vector<FusedLeaks> read(const std::string& output, std::size_t rays) {
    std::vector<FusedLeaks> all;
    std::istringstream lines(output);
    const double million = 1e6 / static_cast<double>(rays);
    for (std::string line; std::getline(lines, line);) {
        const auto third = line.rfind(','), second = line.rfind(',', third - 1), name = line.rfind(',', second - 1);
        const std::size_t first = std::stoul(line.substr(third + 1));
        all.push_back({line.substr(0, name),
                       {std::stod(line.substr(name + 1)) * million, std::stod(line.substr(second + 1)) * million},
                       first < rays ? std::optional(first) : std::nullopt});
    }
    return all;
}

// Pluecker's edge value stays antisymmetric under contraction: reversing the edge changes the sign of q - p, and so of
// every term.
CaseRow row_of(const FusedLeaks& fused, const LeakTrial& trial) {
    CaseRow row{fused.method + ", fused: edges", "fails: more than 0.1 % leak", in_words(fused.leaks),
                fused.leaks.none > 1000};
    if (fused.method == "Pluecker, float") {
        row.expected = "holds: none leak";
        row.as_expected = fused.leaks.none == 0;
    }
    if (fused.first) row.example = trial.example(*fused.first);
    return row;
}

std::vector<CaseRow> compare_with_fused(const LeakTrial& trial, const std::string& output) {
    std::vector<CaseRow> rows = {trial.never_leaks("watertight, float"), trial.never_leaks("Pluecker, float")};
    for (const auto& fused : read(output, trial.shots().first.size() - 1)) rows.push_back(row_of(fused, trial));
    return rows;
}

}  // namespace

StabilityCase fma_switch(const ChapterRun& run) {
    return {"FMA-SWITCH",
            "EDGE-SHOT once more, by a program in which a*b - c*d is fused, as compilers do by default: an edge is "
            "no longer the same from both sides.",
            [run] {
                const LeakTrial trial(shots_inside(
                    icosphere(3), {0, 0, 0}, {.count = run.sized<std::size_t>(100'000, 10'000), .seed = run.seed}));
                const auto result =
                    run_process(program, {}, {.input = to_bytes(as_file(trial.shots())), .timeout = 60});
                if (result.end == ProcessResult::End::signalled && result.code == SIGILL)
                    return std::vector<CaseRow>{{"watertight, float, fused: edges", "fails: more than 0.1 % leak",
                                                 "skipped: this processor has no fused multiply-add", true}};
                if (!result.succeeded()) throw Error(failure_of(program.filename().string(), result));
                return compare_with_fused(trial, result.output);
            }};
}

}  // namespace raylab
