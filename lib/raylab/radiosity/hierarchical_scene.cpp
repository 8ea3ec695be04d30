#include "raylab/radiosity/hierarchical_scene.h"

#include "raylab/radiosity/hierarchy/hierarchical_power.h"
#include "raylab/radiosity/hierarchy/leaf_mesh.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/vertex_radiosity.h"

#include "raylab/base/error.h"

#include <chrono>
#include <utility>

namespace raylab {

SceneHierarchy scene_hierarchy(const Scene& scene, const SceneHierarchyOptions& options) {
    check_reflectances(scene);
    // Curved surfaces begin as pieces of this side. Every pair of them is looked at, so they are not the smallest.
    constexpr std::size_t pieces_of_curved_scene = 1000;
    const PatchMesh roots = pieces_of(scene, {edge_for_patches(scene, pieces_of_curved_scene), options.lines});
    if (roots.patches.empty()) throw Error({scene.source}, "at least one surface", "none");
    HierarchyOptions solving = options.solving;
    solving.smallest = options.edge ? *options.edge : edge_for_patches(scene, options.patches);

    const auto begun = std::chrono::steady_clock::now();
    auto solution = hierarchical_radiosity(roots, PatchVisibility(roots), solving);
    const auto solved = std::chrono::steady_clock::now();
    LeafMesh leaves = leaf_mesh(roots, solution.elements);
    auto patches = of_leaves(solution.light.radiosity, leaves);
    auto reflectance = of_leaves(solution.light.reflectance, leaves);
    auto mesh = std::make_unique<const PatchMesh>(std::move(leaves.mesh));
    auto visibility = std::make_unique<const PatchVisibility>(*mesh);
    auto vertices = vertex_radiosities(*mesh, patches);
    const PowerBalance power = hierarchical_power(solution, solving.threads);
    const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
    return {.mesh = std::move(mesh),
            .visibility = std::move(visibility),
            .elements = std::move(leaves.elements),
            .solution = std::move(solution),
            .reflectance = std::move(reflectance),
            .patches = std::move(patches),
            .vertices = std::move(vertices),
            .power = power,
            .seconds = {seconds(begun, solved), seconds(solved, std::chrono::steady_clock::now())}};
}

}  // namespace raylab
