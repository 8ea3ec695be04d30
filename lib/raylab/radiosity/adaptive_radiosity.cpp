#include "raylab/radiosity/adaptive_radiosity.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/mesh/quartered_mesh.h"
#include "raylab/scene/mean_of_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace raylab {

namespace {

// The mean over the area of what is reflected: emitters would make all other differences small.
double mean_reflected(const SceneRadiosity& solved) {
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < solved.mesh->patches.size(); ++i) {
        const Patch& patch = solved.mesh->patches[i];
        const Color emitted = std::numbers::pi * solved.mesh->material(patch).emission;
        sum += patch.area * mean_of_channels(solved.solution.radiosity[i] - emitted);
        area += patch.area;
    }
    return sum / area;
}

// The patches with corners of which one is brighter than another by more than this, and whose quarters are large
// enough.
std::vector<bool> where_light_changes(const SceneRadiosity& solved, double most, double smallest) {
    std::vector<bool> chosen;
    for (const Patch& patch : solved.mesh->patches) {
        double least = std::numeric_limits<double>::infinity(), largest = 0;
        for (std::uint32_t i = 0; i < patch.corner_count; ++i) {
            const double bright = mean_of_channels(solved.vertices[patch.vertices[i]]);
            least = std::min(least, bright);
            largest = std::max(largest, bright);
        }
        // An edge that was made by halving may have lost its last bit.
        constexpr double rounding = 1 - 1e-9;
        chosen.push_back(largest - least > most && longest_side(patch) / 2 >= smallest * rounding);
    }
    return chosen;
}

}  // namespace

SceneRadiosity adaptive_radiosity(const Scene& scene, const SceneRadiosityOptions& options, double difference) {
    if (!(difference > 0)) throw Error(fmt::format("expected a difference over 0 for patches, found {}", difference));
    constexpr double coarse = 8;  // three times quartered
    const double smallest = options.edge ? *options.edge : edge_for_patches(scene, options.patches);
    SceneRadiosity solved = mesh_radiosity(scene, patch_mesh(scene, {coarse * smallest, options.lines}), options);
    while (true) {
        const auto chosen = where_light_changes(solved, difference * mean_reflected(solved), smallest);
        if (std::ranges::none_of(chosen, std::identity())) return solved;
        const auto before = solved.seconds;
        const auto reused = solved.reused;
        solved = mesh_radiosity(scene, quartered_mesh(*solved.mesh, chosen), options, QuarteredFrom{solved, chosen});
        solved.seconds.mesh += before.mesh;
        solved.seconds.form_factors += before.form_factors;
        solved.seconds.light += before.light;
        solved.seconds.solve += before.solve;
        solved.reused.form_factors &= reused.form_factors;
        solved.reused.solution &= reused.solution;
    }
}

}  // namespace raylab
