#include "raylab/radiosity/hierarchical_scene.h"

#include "raylab/radiosity/hierarchy/hierarchical_power.h"
#include "raylab/radiosity/hierarchy/leaf_mesh.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/vertex_radiosity.h"

#include "raylab/base/error.h"

#include <chrono>
#include <utility>

namespace raylab {

namespace {

struct SolvedLinks {
    HierarchicalRadiosity solution;
    SceneHierarchy::Reused reused;
};

// From the cache as a whole if nothing changed but the camera, else by what it knows of links.
SolvedLinks solved_links(const PatchMesh& roots, const PatchVisibility& visibility, HierarchyOptions solving,
                         RadiosityCache* cache) {
    if (!cache) return {hierarchical_radiosity(roots, visibility, solving), {}};
    const std::string key = links_key(roots, solving.rays), solved_key = hierarchy_key(key, roots, solving);
    if (auto kept = cache->hierarchy(solved_key, roots, solving.smallest))
        return {std::move(*kept), {.solution = true}};
    KnownLinks known = cache->links(key).value_or(KnownLinks{});
    solving.known = &known;
    auto solution = hierarchical_radiosity(roots, visibility, solving);
    cache->keep(key, known);
    cache->keep(solved_key, solution);
    const HierarchyWork& work = solution.work;
    return {std::move(solution), {.links = work.known, .of = work.estimates}};
}

}  // namespace

SceneHierarchy scene_hierarchy(const Scene& scene, const SceneHierarchyOptions& options) {
    check_reflectances(scene);
    // Curved surfaces begin as pieces of this side. Every pair of them is looked at, so they are not the smallest.
    constexpr std::size_t pieces_of_curved_scene = 1000;
    const PatchMesh roots = pieces_of(scene, {edge_for_patches(scene, pieces_of_curved_scene), options.lines});
    if (roots.patches.empty()) throw Error({scene.source}, "at least one surface", "none");
    HierarchyOptions solving = options.solving;
    solving.smallest = options.edge ? *options.edge : edge_for_patches(scene, options.patches);

    const auto begun = std::chrono::steady_clock::now();
    auto [solution, reused] = solved_links(roots, PatchVisibility(roots), solving, options.cache);
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
            .seconds = {seconds(begun, solved), seconds(solved, std::chrono::steady_clock::now())},
            .reused = reused};
}

}  // namespace raylab
