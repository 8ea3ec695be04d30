#include "mesh_cases.h"

#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/radiosity/vertex_radiosity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::cornell {

namespace {

Object square(const Vec3f& middle, float side, float up, std::size_t material, Sides sides) {
    const float h = side / 2;  // `up`: 1 or -1, the way that the front looks
    const auto corner = [&](float x, float z) { return middle + Vec3f{x * h, 0, up * z * h}; };
    return {.shape = Polygon{{corner(-1, -1), corner(-1, 1), corner(1, 1), corner(1, -1)}},
            .front = material,
            .back = material,
            .sides = sides};
}

// A plate between a small light and a floor.
Scene floor_with_shadow(float plate, float height) {
    Scene scene;
    scene.source = "a plate over a floor";
    scene.materials = {{.name = "floor", .diffuse = Color(0.5)},
                       {.name = "light", .diffuse = Color(0), .emission = Color(30)},
                       {.name = "plate", .diffuse = Color(0.05)}};
    scene.objects = {square({0, 0, 0}, 1, 1, 0, Sides::front), square({0, 1, 0}, 0.1f, -1, 1, Sides::front),
                     square({0, height, 0}, plate, 1, 2, Sides::both)};
    return scene;
}

// How bright the floor's middle, in the shadow, is shown, as a share of a place beside it.
double shadow_of(const PatchMesh& mesh, const Radiosities& patches) {
    const auto shown = [&](const Vec3d& at) { return patches[patch_at(mesh, 0, FacetSide::front, at).patch].g; };
    return shown({0.001, 0, 0.001}) / shown({0.26, 0, 0.26});
}

CaseRow shadow_row(const std::string& method, double shadow, double dark, bool is_found) {
    const std::string words = fmt::format("the shadow's middle has {:.2g} of the light beside it", shadow);
    if (is_found) return {method, fmt::format("holds: at most {:g}", dark), words, shadow <= dark};
    return {method, fmt::format("fails: more than {:g}", dark), words, shadow > dark};
}

std::vector<CaseRow> hierarchy_refine(const ChapterRun& run) {
    const Scene scene = floor_with_shadow(0.15f, 0.2f);
    const auto row = [&](double error, bool is_found) {
        const auto solved = scene_hierarchy(scene, {.edge = 0.01, .solving = {.error = error, .threads = run.threads}});
        return shadow_row(fmt::format("hierarchical, error of a link {:g}, {} patches", error, solved.patches.size()),
                          shadow_of(*solved.mesh, solved.patches), 0.2, is_found);
    };
    return {row(0.2, false), row(0.02, true), row(0.005, true)};
}

std::vector<CaseRow> shadow_mesh(const ChapterRun& run) {
    const Scene scene = floor_with_shadow(0.05f, 0.02f);
    const auto uniform = [&](double edge, bool is_found) {
        const auto solved =
            scene_radiosity(scene, {.edge = edge, .form_factors = {.rays = 64, .threads = run.threads}});
        return shadow_row(fmt::format("patches of {:g} m, {} of them", edge, solved.mesh->patches.size()),
                          shadow_of(*solved.mesh, solved.solution.radiosity), 0.1, is_found);
    };
    const auto solved = scene_hierarchy(scene, {.edge = 0.01, .solving = {.error = 0.005, .threads = run.threads}});
    return {uniform(1.0 / 9, false), uniform(1.0 / 31, true),
            shadow_row(fmt::format("hierarchical down to 0.01 m, {} patches", solved.patches.size()),
                       shadow_of(*solved.mesh, solved.patches), 0.1, true)};
}

// The largest difference, at the middle of a patch's side, of what the patch shows there and what its small neighbours
// do.
double largest_jump(const PatchMesh& mesh, const Radiosities& vertices) {
    double jump = 0, largest = 0;
    for (const auto& [vertex, ends] : mesh.hanging) {
        const Color shown = 0.5 * (vertices[ends[0]] + vertices[ends[1]]);
        jump = std::max(jump, std::abs(vertices[vertex].g - shown.g));
        largest = std::max(largest, shown.g);
    }
    return jump / largest;
}

std::vector<CaseRow> t_vertex(const ChapterRun& run) {
    const auto solved = scene_hierarchy(floor_with_shadow(0.15f, 0.2f),
                                        {.edge = 0.01, .solving = {.error = 0.01, .threads = run.threads}});
    const auto jump = [&](TVertices treatment) {
        return largest_jump(*solved.mesh, vertex_radiosities(*solved.mesh, solved.patches, treatment));
    };
    const double left = jump(TVertices::left), mended = jump(TVertices::mended);
    const auto words = [&](double found) {
        return fmt::format("{:.2g} of the largest radiosity, at {} T-vertices", found, solved.mesh->hanging.size());
    };
    return {{"T-vertices as their own patches have them", "fails: a crack of more than 0.02", words(left), left > 0.02},
            {"T-vertices mended", "holds: no crack over 1e-12", words(mended), mended < 1e-12}};
}

// A floor across which stands a wall, with a light on one side, below the wall's upper edge.
Scene floor_with_wall() {
    Scene scene;
    scene.source = "a wall on a floor";
    scene.materials = {{.name = "floor", .diffuse = Color(0.5)}, {.name = "wall", .diffuse = Color(0)}};
    const Polygon wall{{{-0.05f, 0, -1}, {-0.05f, 0, 1}, {-0.05f, 1, 1}, {-0.05f, 1, -1}}};
    scene.objects = {square({0, 0, 0}, 1, 1, 0, Sides::front), {.shape = wall, .front = 1, .back = 1}};
    scene.lights = {{.kind = PointLight{{-0.3, 0.3, 0}}, .color = Color(1)}};
    return scene;
}

// The largest radiosity that is shown on the dark side, as a share of the largest of all.
double leak(const SceneRadiosity& solved) {
    double most = 0, largest = 0;
    for (const Color& b : solved.vertices) largest = std::max(largest, b.g);
    for (const double apart : {1e-3, 0.01, 0.02, 0.04, 0.08}) {
        const PatchPlace at = patch_at(*solved.mesh, 0, FacetSide::front, {-0.05 + apart, 0, 0.01});
        const Patch& patch = solved.mesh->patches[at.patch];
        double shown = 0;
        for (std::uint32_t i = 0; i < patch.corner_count; ++i)
            shown += at.weights[i] * solved.vertices[patch.vertices[i]].g;
        most = std::max(most, shown);
    }
    return most / largest;
}

std::vector<CaseRow> light_leak(const ChapterRun& run) {
    const auto row = [&](double edge, MeshLines lines) {
        const bool is_cut = lines == MeshLines::contact;
        const auto solved = scene_radiosity(
            floor_with_wall(),
            {.edge = edge, .lines = lines, .form_factors = {.threads = run.threads}, .light_points = 64});
        const double found = leak(solved);
        return CaseRow{fmt::format("patches of {:g} m, {}", edge, is_cut ? "cut at the wall's line" : "past the line"),
                       is_cut ? "holds: no light behind the wall" : "fails: more than 0.1 of the light leaks",
                       fmt::format("beside the wall, on its dark side: {:.2g} of the largest radiosity", found),
                       is_cut ? found == 0 : found > 0.1};
    };
    return {row(0.2, MeshLines::none), row(0.04, MeshLines::none), row(0.2, MeshLines::contact)};
}

}  // namespace

std::vector<StabilityCase> mesh_cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"LIGHT-LEAK", "a wall that stands on a floor, over the middle of patches", of(light_leak)},
            {"SHADOW-MESH", "a shadow whose edge is sharper than patches are small", of(shadow_mesh)},
            {"T-VERTEX", "a small patch's vertex on the side of a large patch", of(t_vertex)},
            {"HIERARCHY-REFINE", "links with so loose an error that a shadow is not looked for", of(hierarchy_refine)}};
}

}  // namespace raylab::cornell
