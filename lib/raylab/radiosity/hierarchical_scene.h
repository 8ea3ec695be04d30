#pragma once

#include "raylab/radiosity/cache/radiosity_cache.h"
#include "raylab/radiosity/hierarchy/hierarchical_radiosity.h"
#include "raylab/radiosity/radiosity_picture.h"
#include "raylab/radiosity/system/power_balance.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace raylab {

struct SceneHierarchyOptions {
    std::optional<double> edge = {};  // the smallest element's longest side, metres; absent: that of about `patches`
                                      // equal patches
    std::size_t patches = 1000;
    MeshLines lines = MeshLines::none;  // along which roots are cut
    HierarchyOptions solving = {};      // its `smallest` is `edge`
    RadiosityCache* cache = nullptr;    // where links and the solution are kept between runs; none: they are computed
};

/// A scene solved by hierarchical radiosity, with its leaves as the patches of a picture.
struct SceneHierarchy {
    std::unique_ptr<const PatchMesh> mesh;
    std::unique_ptr<const PatchVisibility> visibility;
    std::vector<std::uint32_t> elements;  // of each patch, in solution.elements
    HierarchicalRadiosity solution;
    std::vector<Color> reflectance;  // of each patch
    Radiosities patches, vertices;
    PowerBalance power;
    struct Seconds {
        double solve, mesh;
    } seconds;

    struct Reused {
        std::uint64_t links = 0, of = 0;  // so many of the links that were asked for
        bool solution = false;
    } reused = {};  // what came from options.cache

    RadiosityView view() const { return {*mesh, *visibility, patches, vertices}; }
};

/// Solves a scene. It throws an Error for what cannot be solved, as scene_radiosity() does.
SceneHierarchy scene_hierarchy(const Scene& scene, const SceneHierarchyOptions& options);

}  // namespace raylab
