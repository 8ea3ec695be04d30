#include "raylab/radiosity/scene_radiosity.h"

#include "raylab/base/error.h"
#include "raylab/base/tiles.h"
#include "raylab/radiosity/direct_light.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/system/read_system.h"
#include "raylab/radiosity/system/symmetric_rows.h"
#include "raylab/radiosity/vertex_radiosity.h"
#include "raylab/scene/background.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <numbers>
#include <utility>

namespace raylab {

namespace {

class Clock {
public:
    // The seconds since the last call.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What a patch is by itself.
struct Surfaces {
    std::vector<double> area;
    std::vector<Color> emission, reflectance;
};

Surfaces surfaces(const PatchMesh& mesh) {
    Surfaces result;
    for (const Patch& patch : mesh.patches) {
        result.area.push_back(patch.area);
        result.emission.push_back(std::numbers::pi * mesh.material(patch).emission);
        result.reflectance.push_back(patch_reflectance(mesh, patch));
    }
    return result;
}

// What the background sends in through the share of a patch's view that no other patch fills. The inside of a box
// without a bottom, which the floor below it sees, lets nothing in.
void add_background(RadiositySystem& system, const PatchMesh& mesh, const PatchVisibility& visibility, int threads) {
    if (!sends_light(mesh.model.scene.background)) return;
    constexpr int rays = 64;
    const auto sums = each_row_sum(system.form_factors, threads);
    for_each_piece(sums.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i) {
            const auto around =
                visibility.surroundings({static_cast<std::uint32_t>(i), mesh.patches[i]}, rays, traversal);
            system.emission[i] += system.reflectance[i] * background_light(around, sums[i]);
        }
    });
}

// What is known of a quartered mesh's form factors.
KnownFormFactors known_form_factors(const QuarteredFrom& from) {
    KnownFormFactors known{from.before.system.form_factors, from.before.scales, from.before.work, {}};
    for (std::uint32_t i = 0; i < from.chosen.size(); ++i)
        known.before.insert(known.before.end(), from.chosen[i] ? 4 : 1,
                            from.chosen[i] ? std::nullopt : std::optional(i));
    return known;
}

ScaledFormFactors scaled_form_factors(const PatchMesh& mesh, const PatchVisibility& visibility,
                                      const SceneRadiosityOptions& options, const std::optional<QuarteredFrom>& from) {
    const int threads = options.form_factors.threads;
    const auto known = from ? std::optional(known_form_factors(*from)) : std::nullopt;
    auto [factors, work] = patch_form_factors(mesh, visibility, options.form_factors, known ? &*known : nullptr);
    if (options.rows == SceneRadiosityOptions::Rows::raw) {
        const RowSums sums = row_sums(factors, threads);
        return {std::move(factors), std::vector<double>(mesh.patches.size(), 1.0), work, sums, sums};
    }
    std::vector<double> area;
    for (const Patch& patch : mesh.patches) area.push_back(patch.area);
    // Rows just below 1 are brought to 1 as far as the factors in full view explain it. The shadow rays' scatter
    // does not: with it, rows that lose light would be lifted, and the open Cornell box became 4 % too bright.
    auto scaled = symmetric_rows(std::move(factors), area, work.error_in_full_view, threads);
    return {std::move(scaled.form_factors), std::move(scaled.scales), work, scaled.before, scaled.after};
}

std::string key_of_form_factors(const PatchMesh& mesh, const SceneRadiosityOptions& options,
                                const std::optional<QuarteredFrom>& from) {
    const std::string scaling = options.rows == SceneRadiosityOptions::Rows::raw ? "raw" : "symmetric";
    return form_factors_key(mesh, options.form_factors, from ? scaling + " after " + from->before.key : scaling);
}

template <class Result>
struct KeptOrComputed {
    Result result;
    bool is_kept;
};

// A step's result: what the cache holds, or what is computed, and kept at once, so that it outlives a later failure.
template <class Result>
KeptOrComputed<Result> kept_or_computed(RadiosityCache* cache, const std::string& key,
                                        const std::function<std::optional<Result>()>& kept,
                                        const std::function<Result()>& computed) {
    if (cache)
        if (auto found = kept()) return {std::move(*found), true};
    KeptOrComputed<Result> made{computed(), false};
    if (cache) cache->keep(key, made.result);
    return made;
}

MemoryNeed matrix_need(const PatchMesh& mesh) {
    MemoryNeed need = form_factors_need(mesh.patches.size());
    need.why += "; --mesh hierarchical needs no matrix, and fewer --patches a smaller one";
    return need;
}

void refuse_darkness(const RadiositySystem& system, const Scene& scene) {
    if (std::ranges::all_of(system.emission, [](const Color& e) { return e == Color{0, 0, 0}; })) throw no_light(scene);
}

}  // namespace

SceneRadiosity scene_radiosity(const Scene& scene, const SceneRadiosityOptions& options) {
    Clock clock;
    const double edge = options.edge ? *options.edge : edge_for_patches(scene, options.patches);
    PatchMesh mesh = patch_mesh(scene, {edge, options.lines});
    const double seconds = clock.lap();
    SceneRadiosity solved = mesh_radiosity(scene, std::move(mesh), options);
    solved.seconds.mesh += seconds;
    return solved;
}

SceneRadiosity mesh_radiosity(const Scene& scene, PatchMesh patches, const SceneRadiosityOptions& options,
                              const std::optional<QuarteredFrom>& from) {
    Clock clock;
    check_reflectances(scene);
    if (patches.patches.empty()) throw Error({scene.source}, "at least one surface", "none");
    const MemoryLimit limit = from ? what_is_left(options.limit, from->before.bytes) : options.limit;
    check_memory(matrix_need(patches), limit, {scene.source});
    if (options.before_memory) options.before_memory(matrix_need(patches));
    const int threads = options.form_factors.threads;
    auto mesh = std::make_unique<const PatchMesh>(std::move(patches));
    auto visibility = std::make_unique<const PatchVisibility>(*mesh);
    const double mesh_seconds = clock.lap();

    const std::string key = options.cache ? key_of_form_factors(*mesh, options, from) : "";
    auto [computed, factors_are_reused] = kept_or_computed<ScaledFormFactors>(
        options.cache, key, [&] { return options.cache->form_factors(key, mesh->patches.size()); },
        [&] { return scaled_form_factors(*mesh, *visibility, options, from); });
    auto [factors, scales, work, before, after] = std::move(computed);
    auto [area, emission, reflectance] = surfaces(*mesh);
    const double factor_seconds = clock.lap();

    const auto direct = direct_light(*mesh, *visibility, options.light_points, threads);
    for (std::size_t i = 0; i < direct.size(); ++i) emission[i] += reflectance[i] * direct[i];
    RadiositySystem system{std::move(area), std::move(emission), std::move(reflectance), std::move(factors)};
    add_background(system, *mesh, *visibility, threads);
    refuse_darkness(system, scene);
    const double light_seconds = clock.lap();

    SolverOptions solving = options.solving;
    solving.form_factor_error = std::max(solving.form_factor_error, work.error);
    solving.threads = threads;
    const double bytes = form_factors_need(system.patches()).bytes;
    solving.limit = what_is_left(limit, bytes);
    const std::string solved_key = options.cache ? solution_key(key, system, options.solver, solving) : "";
    auto [solution, solution_is_reused] = kept_or_computed<Solution>(
        options.cache, solved_key, [&] { return options.cache->solution(solved_key, system.patches()); },
        [&] { return solve(system, solver_named(options.solver), solving); });
    Radiosities vertices = vertex_radiosities(*mesh, solution.radiosity);
    return {.mesh = std::move(mesh),
            .visibility = std::move(visibility),
            .work = work,
            .scales = std::move(scales),
            .rows_before = before,
            .rows_after = after,
            .system = std::move(system),
            .solution = std::move(solution),
            .vertices = std::move(vertices),
            .bytes = bytes,
            .seconds = {mesh_seconds, factor_seconds, light_seconds, clock.lap()},
            .reused = {factors_are_reused, solution_is_reused},
            .key = key};
}

}  // namespace raylab
