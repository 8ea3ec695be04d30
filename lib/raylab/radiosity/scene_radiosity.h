#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/radiosity/cache/radiosity_cache.h"
#include "raylab/radiosity/patch_form_factors.h"
#include "raylab/radiosity/radiosity_picture.h"
#include "raylab/radiosity/solve/solver.h"
#include "raylab/radiosity/system/row_sums.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

struct SceneRadiosityOptions {
    std::optional<double> edge = {};  // of patches, metres; absent: the edge that makes about `patches`
    std::size_t patches = 1000;
    MeshLines lines = MeshLines::none;
    FormFactorOptions form_factors = {};
    int light_points = 16;  // of each patch, from which a shadow ray goes to every light
    enum class Rows {
        symmetric,  // scaled so that no row's sum is over 1, and reciprocity holds
        raw,        // as computed
    } rows = Rows::symmetric;
    std::string solver = "auto";
    SolverOptions solving = {};
    MemoryLimit limit = {};
    std::function<void(const MemoryNeed&)> before_memory = {};  // is told what form factors will take before they do
    RadiosityCache* cache = nullptr;  // where steps are kept between runs; none: they are computed
};

/// The radiosity of a scene, and each step's result on the way: a step is done again only when what it is made of
/// changes. Geometry makes the form factors; emission, lights and reflectances make the solution; the camera makes only
/// the picture.
struct SceneRadiosity {
    std::unique_ptr<const PatchMesh> mesh;
    std::unique_ptr<const PatchVisibility> visibility;
    FormFactorWork work;
    std::vector<double> scales;       // of each patch: F_ij was multiplied by those of i and j
    RowSums rows_before, rows_after;  // of the scaling
    RadiositySystem system;           // its emission holds what patches reflect of lights and background, too
    Solution solution;
    Radiosities vertices;
    double bytes;  // of the form factors
    struct Seconds {
        double mesh, form_factors, light, solve;
    } seconds;
    struct Reused {
        bool form_factors = false, solution = false;
    } reused;              // what came from options.cache
    std::string key = {};  // of the form factors there

    RadiosityView view() const { return {*mesh, *visibility, solution.radiosity, vertices}; }
};

/// Solves a scene. It throws an Error for what cannot be solved: no patch, no light, a reflectance outside [0, 1), an
/// infinite plane, more memory than the limit, rows of form factors that exceed 1 by more than their error.
SceneRadiosity scene_radiosity(const Scene& scene, const SceneRadiosityOptions& options);

/// The same on a mesh that is given; options.edge and options.patches are not asked. `before` is the solution of the
/// mesh of which this one was made by quartering the chosen patches: its form factors are used again.
struct QuarteredFrom {
    const SceneRadiosity& before;
    const std::vector<bool>& chosen;
};
SceneRadiosity mesh_radiosity(const Scene& scene, PatchMesh mesh, const SceneRadiosityOptions& options,
                              const std::optional<QuarteredFrom>& from = std::nullopt);

}  // namespace raylab
