#include "pictures.h"

#include "raylab/image/color_map.h"
#include "raylab/image/draw.h"
#include "raylab/image/to_pixel.h"
#include "raylab/radiosity/form_factor/hemicube.h"
#include "raylab/radiosity/system/gathered.h"
#include "raylab/radiosity/vertex_radiosity.h"
#include "raylab/report/radiosity/walk_through.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::cornell {

SceneRadiosity solved(const Scene& scene, std::size_t patches, const ChapterRun& run) {
    return scene_radiosity(scene, {.patches = patches, .form_factors = {.threads = run.threads}});
}

Image shown(const SceneRadiosity& solved, const Scene& scene, ImageSize size, RadiosityShading shading,
            const ChapterRun& run) {
    const int per_side = shading == RadiosityShading::gather ? 1 : 3;
    return radiosity_picture(solved.view(), camera_frame(scene.camera, size), shading,
                             {.samples = {.per_side = per_side}, .threads = run.threads});
}

Image shown(const SceneRadiosity& solved, const Radiosities& radiosity, const Scene& scene, ImageSize size,
            const ChapterRun& run) {
    const Radiosities vertices = vertex_radiosities(*solved.mesh, radiosity);
    const RadiosityView view{*solved.mesh, *solved.visibility, radiosity, vertices};
    return radiosity_picture(view, camera_frame(scene.camera, size), RadiosityShading::vertices,
                             {.samples = {.per_side = 3}, .threads = run.threads});
}

std::string walk_through_box(const SceneRadiosity& solved, const Scene& scene) {
    const SolvedScene shown{*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices};
    constexpr double as_pictures = 1;  // the exposure of the chapter's pictures
    return walk_through_page(shown, scene.camera, "The Cornell box", as_pictures);
}

Radiosities after_one_reflection(const SceneRadiosity& solved) {
    const RadiositySystem& system = solved.system;
    Radiosities result = system.emission;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += system.reflectance[i] * gathered(system.form_factors.row(i), system.emission);
    return result;
}

std::array<Radiosities, 4> after_shots(const SceneRadiosity& solved) {
    constexpr std::array shots{1, 2, 10, 100};
    std::array<Radiosities, 4> result;
    SolverOptions options{.iterations = shots.back()};
    options.watch = [&](const SolverStep& step) {
        const auto at = std::ranges::find(shots, step.iteration);
        if (at != shots.end())
            result[static_cast<std::size_t>(at - shots.begin())].assign(step.radiosity.begin(), step.radiosity.end());
    };
    solver_named("shooting").run(solved.system, options);
    return result;
}

Image matrix_picture(const SceneRadiosity& solved) {
    const FormFactors& factors = solved.system.form_factors;
    const auto n = static_cast<int>(factors.patches());
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = std::max(largest, std::ranges::max(factors.row(static_cast<std::size_t>(i))));
    Image image(n, n);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double factor = factors.at(static_cast<std::size_t>(y), static_cast<std::size_t>(x));
            image.at(x, y) = heat_color(factor > 0 ? std::max(0.0, 1 + std::log10(factor / largest) / 3) : 0);
        }
    return image;
}

namespace {

// A patch of the floor between both boxes and the red wall.
std::size_t beside_the_boxes(const PatchMesh& mesh) {
    const auto distance = [](const Patch& patch) {
        return patch.normal.y < 0.99 ? 1e9 : glm::distance(patch.center, Vec3d{0.42, 0, 0.16});
    };
    return static_cast<std::size_t>(std::ranges::min_element(mesh.patches, {}, distance) - mesh.patches.begin());
}

}  // namespace

Image hemicube_picture(const SceneRadiosity& solved) {
    const PatchMesh& mesh = *solved.mesh;
    std::vector<std::span<const Vec3d>> polygons;
    for (const Patch& patch : mesh.patches) polygons.push_back(patch.polygon());
    const Patch& from = mesh.patches[beside_the_boxes(mesh)];
    constexpr int resolution = 240;
    const Hemicube cube = hemicube(from.center, from.normal, {0, 0, 1}, polygons, resolution);
    Image image(2 * resolution, 2 * resolution);
    constexpr double side = 2 * resolution;
    fill_convex(image, {{0, 0}, {side, 0}, {side, side}, {0, side}}, ink::white);
    const auto color = [&](const HemicubeFace& face, int column, int row) {
        const int seen = face.nearest[static_cast<std::size_t>(row * face.columns + column)];
        if (seen == HemicubeFace::nothing_seen) return ink::black;
        return to_pixel(
            glm::min(solved.solution.radiosity[static_cast<std::size_t>(seen)] / std::numbers::pi, Color(1)));
    };
    // The upper face in the middle; the halves around it begin at its edges, where their row 0 is.
    constexpr int h = resolution / 2;
    for (std::size_t f = 0; f < cube.faces.size(); ++f)
        for (int row = 0; row < cube.faces[f].rows; ++row)
            for (int column = 0; column < cube.faces[f].columns; ++column) {
                const Pixel pixel = color(cube.faces[f], column, row);
                const int last = resolution - 1;
                if (f == 0) image.at(h + column, h + row) = pixel;
                if (f == 1) image.at(h + resolution + row, h + column) = pixel;
                if (f == 2) image.at(h + column, h - 1 - row) = pixel;
                if (f == 3) image.at(h - 1 - row, h + last - column) = pixel;
                if (f == 4) image.at(h + last - column, h + resolution + row) = pixel;
            }
    draw_rectangle(image, {h, h}, {h + resolution, h + resolution}, 2, ink::sky_blue);
    return image;
}

ImageSize half_wide(const ChapterRun& run) { return run.sized<ImageSize>({480, 480}, {160, 160}); }

}  // namespace raylab::cornell
