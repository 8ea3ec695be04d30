#include "meshing_question.h"

#include "raylab/radiosity/adaptive_radiosity.h"
#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace raylab::cornell {

namespace {

// A solved mesh, whatever method it is of.
struct SolvedMesh {
    const PatchMesh& mesh;
    const Radiosities& patches;
};

// The root mean square of the difference at the centres of a finer mesh's patches, by their areas, relative to the
// mean.
double error_of(const SolvedMesh& solved, const SolvedMesh& truth) {
    double sum = 0, mean = 0, area = 0;
    for (std::size_t i = 0; i < truth.mesh.patches.size(); ++i) {
        const Patch& patch = truth.mesh.patches[i];
        if (truth.mesh.material(patch).emission != Color(0)) continue;  // it is the same in all of them
        const PatchPlace at = patch_at(solved.mesh, truth.mesh.occluder(patch), patch.side, patch.center);
        const double apart = solved.patches[at.patch].g - truth.patches[i].g;
        sum += patch.area * apart * apart;
        mean += patch.area * truth.patches[i].g;
        area += patch.area;
    }
    return std::sqrt(sum * area) / mean;
}

// Once: a solution takes much longer than the clock's steps.
Spread timed(const std::function<void()>& work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    const double nanoseconds =
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begun).count();
    return {nanoseconds, nanoseconds, nanoseconds};
}

std::string soonest_mesh(const Experiment& experiment) {
    const auto best = std::ranges::min_element(experiment.rows, {}, [](const Measurement& row) {
        return row.error <= 0.1 ? row.nanoseconds.median : std::numeric_limits<double>::infinity();
    });
    if (best->error > 0.1) return "None comes within a tenth of the mean";
    return fmt::format("Within a tenth of the mean soonest: {} by {}, in {:.2g} s", best->method, best->knob,
                       best->nanoseconds.median * 1e-9);
}

}  // namespace

Experiment measure_meshing(const ChapterRun& run) {
    const Scene scene = read_scene(run.scene);
    Experiment experiment{.question = "meshing",
                          .title = "How soon is the Cornell box's light right?",
                          .error_axis = "error of the radiosities, relative to their mean",
                          .rows = {},
                          .answer = soonest_mesh};
    const FormFactorOptions shadow_rays{.threads = run.threads};
    const auto fine = scene_radiosity(
        scene, {.patches = run.sized<std::size_t>(5000, 1000), .form_factors = {.rays = 16, .threads = run.threads}});
    const SolvedMesh truth{*fine.mesh, fine.solution.radiosity};
    const auto add = [&](const std::string& method, const std::string& source, const std::string& knob,
                         const Spread& nanoseconds, const SolvedMesh& solved) {
        experiment.rows.push_back({.method = method,
                                   .number = "double",
                                   .workload = "Cornell box",
                                   .knob = fmt::format("{}, {} patches", knob, solved.mesh.patches.size()),
                                   .source = source,
                                   .error = error_of(solved, truth),
                                   .nanoseconds = nanoseconds,
                                   .queries = 1});
    };
    for (const std::size_t patches : run.sized<std::vector<std::size_t>>({100, 300, 1000, 2500}, {100, 300})) {
        std::optional<SceneRadiosity> solved;
        const Spread time =
            timed([&] { solved = scene_radiosity(scene, {.patches = patches, .form_factors = shadow_rays}); });
        add("equal patches", "Goral et al., SIGGRAPH 84", "one size", time,
            {*solved->mesh, solved->solution.radiosity});
    }
    for (const double difference : run.sized<std::vector<double>>({0.5, 0.25}, {0.5})) {
        std::optional<SceneRadiosity> solved;
        const Spread time = timed([&] {
            solved = adaptive_radiosity(
                scene, {.patches = run.sized<std::size_t>(5000, 1000), .form_factors = shadow_rays}, difference);
        });
        add("patches that adapt", "Cohen et al., CG&A 6(3), 1986", fmt::format("difference {:g}", difference), time,
            {*solved->mesh, solved->solution.radiosity});
    }
    for (const double error : run.sized<std::vector<double>>({0.3, 0.1, 0.03, 0.01}, {0.3, 0.1})) {
        std::optional<SceneHierarchy> solved;
        const Spread time = timed([&] {
            solved = scene_hierarchy(scene, {.edge = 0.005, .solving = {.error = error, .threads = run.threads}});
        });
        add("hierarchical", "Hanrahan et al., SIGGRAPH 91", fmt::format("error {:g}", error), time,
            {*solved->mesh, solved->patches});
    }
    return experiment;
}

}  // namespace raylab::cornell
