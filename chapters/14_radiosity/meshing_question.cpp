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

// The root mean square of the difference of what is shown from a finer solution, at the centres of that one's patches,
// by their areas, relative to the mean.
double error_of(const RadiosityView& view, const SceneRadiosity& truth) {
    double sum = 0, mean = 0, area = 0;
    for (std::size_t i = 0; i < truth.mesh->patches.size(); ++i) {
        const Patch& patch = truth.mesh->patches[i];
        if (truth.mesh->material(patch).emission != Color(0)) continue;  // it is the same in all of them
        const PatchPlace at = patch_at(view.mesh, truth.mesh->occluder(patch), patch.side, patch.center);
        const double fine = truth.solution.radiosity[i].g, apart = interpolated_radiosity(view, at).g - fine;
        sum += patch.area * apart * apart;
        mean += patch.area * fine;
        area += patch.area;
    }
    return std::sqrt(sum * area) / mean;
}

/// A room, and how right its light is wanted.
struct Room {
    std::string name;
    Scene scene;
    double wanted;      // an error
    int rays;           // a pair of patches; 0: the room is empty, and nothing hides anything
    std::size_t truth;  // patches
};

constexpr std::size_t walls_and_light = 6;  // of the box's polygons; the others are the blocks'

std::vector<Room> rooms_of(const ChapterRun& run) {
    const Scene box = read_scene(run.scene);
    Scene empty = box;
    empty.objects.resize(walls_and_light);
    return {{"Cornell box", box, 0.1, 8, run.sized<std::size_t>(5000, 1000)},
            {"the same without blocks", empty, 0.01, 0, run.sized<std::size_t>(6000, 1500)}};
}

/// Solves a room by many meshes and methods, and compares each with the room's truth.
class Race {
public:
    Race(const Room& room, const ChapterRun& run, std::vector<Measurement>& rows)
        : room_(room),
          run_(run),
          rows_(rows),
          truth_(scene_radiosity(room.scene, {.patches = room.truth, .form_factors = by("auto", 2 * room.rays)})) {}

    void equal_patches(const std::string& title, const std::string& source, const std::string& method) {
        for (const std::size_t patches : run_.sized<std::vector<std::size_t>>({100, 300, 1000, 2500}, {100, 300})) {
            if (method != "auto" && patches > 1000) continue;
            const auto solve = [&] {
                return scene_radiosity(room_.scene, {.patches = patches, .form_factors = by(method, room_.rays)});
            };
            add(title, source, "one size", solve, [](const SceneRadiosity& solved) { return solved.work.links; });
        }
    }

    void patches_that_adapt() {
        for (const double difference : run_.sized<std::vector<double>>({0.5, 0.25}, {0.5})) {
            const auto solve = [&] {
                return adaptive_radiosity(
                    room_.scene,
                    {.patches = run_.sized<std::size_t>(5000, 1000), .form_factors = by("auto", room_.rays)},
                    difference);
            };
            add("patches that adapt", "Cohen et al., CG&A 6(3), 1986", fmt::format("difference {:g}", difference),
                solve, [](const SceneRadiosity& solved) { return solved.work.links; });
        }
    }

    void links() {
        for (const double error : run_.sized<std::vector<double>>({0.3, 0.1, 0.03, 0.01}, {0.3, 0.1})) {
            const auto solve = [&] {
                return scene_hierarchy(
                    room_.scene,
                    {.edge = 0.005, .solving = {.error = error, .rays = room_.rays, .threads = run_.threads}});
            };
            add("hierarchical", "Hanrahan et al., SIGGRAPH 91", fmt::format("error {:g}", error), solve,
                [](const SceneHierarchy& solved) { return solved.solution.work.links; });
        }
    }

private:
    FormFactorOptions by(const std::string& method, int rays) const {
        return {.method = method, .rays = rays, .effort = method == "hemicube" ? 128 : 0, .threads = run_.threads};
    }

    // Timed once: a solution takes much longer than the clock's steps.
    void add(const std::string& method, const std::string& source, const std::string& knob, const auto& solve,
             const auto& form_factors) {
        const auto begun = std::chrono::steady_clock::now();
        const auto solved = solve();
        const double nanoseconds =
            std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begun).count();
        rows_.push_back({.method = method,
                         .number = "double",
                         .workload = room_.name,
                         .knob = fmt::format("{}, {} patches", knob, solved.mesh->patches.size()),
                         .source = source,
                         .error = error_of(solved.view(), truth_),
                         .nanoseconds = {nanoseconds, nanoseconds, nanoseconds},
                         .queries = 1,
                         .counts = {{"form factors", static_cast<double>(form_factors(solved))}}});
    }

    const Room& room_;
    const ChapterRun& run_;
    std::vector<Measurement>& rows_;
    SceneRadiosity truth_;
};

std::string soonest_mesh(const Experiment& experiment, const std::vector<std::pair<std::string, double>>& wanted) {
    std::string text;
    for (const auto& [room, error] : wanted) {
        const Measurement* best = nullptr;
        for (const Measurement& row : experiment.rows)
            if (row.workload == room && row.error <= error &&
                (!best || row.nanoseconds.median < best->nanoseconds.median))
                best = &row;
        text += (text.empty() ? "" : "; ") + fmt::format("{}: within {:g} % soonest {}", room, 100 * error,
                                                         best ? fmt::format("by {}, {}, in {:.2g} s", best->method,
                                                                            best->knob, best->nanoseconds.median * 1e-9)
                                                              : "by none of these");
    }
    return text;
}

}  // namespace

Experiment measure_meshing(const ChapterRun& run) {
    const auto rooms = rooms_of(run);
    std::vector<std::pair<std::string, double>> wanted;
    for (const Room& room : rooms) wanted.emplace_back(room.name, room.wanted);
    Experiment experiment{.question = "meshing",
                          .title = "Which mesh and method has the light right soonest?",
                          .error_axis = "error of what is shown, relative to its mean",
                          .rows = {},
                          .answer = [wanted](const Experiment& all) { return soonest_mesh(all, wanted); }};
    for (const Room& room : rooms) {
        Race race(room, run, experiment.rows);
        race.equal_patches("equal patches", "Goral et al., SIGGRAPH 84; contour integrals", "auto");
        race.equal_patches("equal patches, hemicubes", "Cohen and Greenberg, SIGGRAPH 85", "hemicube");
        race.patches_that_adapt();
        race.links();
    }
    return experiment;
}

}  // namespace raylab::cornell
