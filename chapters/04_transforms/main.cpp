// Chapter 04: how does one shape serve many places?
//
// The figures and tables of the lesson, README.md, in its order; the formulas are there, numbered as here.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "questions.h"
#include "scene_graph.h"
#include "space_drawings.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/lazy.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::transforms;

namespace {

ImageSize sized(const Scene& scene, int part) { return {scene.image.width / part, scene.image.height / part}; }

// 1. A shape is stored once and placed by a transform.
void show_placements(const ChapterRun& run, Page& page, const Scene& scene) {
    page.figure("placed", [&] { return chapter_picture(scene, sized(scene, run.sized(1, 4)), run); },
                {.command = "./raylab render chapters/04_transforms/scene.toml --samples 3x3 -o placed.png"});
    page.figure("scene_graph", [&] { return scene_graph(scene); });
}

// 2. The ray is transformed, not the shape: README (1) to (3).
// 3. Normals do not transform like points, and light is counted in the world: README (4).
void show_spaces(const ChapterRun& run, Page& page, const Scene& scene) {
    Camera near = scene.camera;  // it looks at the four balls in front
    near.target = {0, 0.52, 1.8};
    near.projection = Perspective{18};
    const CameraFrame in_front = camera_frame(near, run.sized(ImageSize{640, 270}, ImageSize{320, 135}), scene.source);
    const auto lit = [&](const std::string& name, Lit how) {
        page.figure(name, [=, &scene, &run] { return draw_lit(scene, in_front, how, run.threads); });
    };
    page.figure("two_spaces", [] { return draw_two_spaces(); });
    page.figure("normal_scale", [] { return draw_normal_scale(); });
    lit("normals_right", Lit::in_world);
    lit("normals_wrong", Lit::with_normals_like_points);
    page.figure("shade_in_world", [] { return draw_shade_in_world(); });
    lit("lit_in_object_space", Lit::in_object_space);
    page.figure("normals",
                [&] {
                    const CameraFrame frame = camera_frame(scene.camera, sized(scene, run.sized(2, 4)), scene.source);
                    return first_hit_picture(scene, *make_accelerator("auto", scene), frame, FirstHitShading::normals,
                                             chapter_rays(run));
                },
                {.keep = Page::Keep::floats});
}

// 4. A scanned mesh that is in memory once.
void show_herd(const ChapterRun& run, Page& page, const Scene& scene) {
    constexpr int rows = 4;
    const auto mesh = std::make_shared<const Lazy<std::shared_ptr<const Mesh>>>([] {
        const auto file = demo_mesh("elephant_coarse");
        return std::make_shared<const Mesh>(file ? read_mesh(*file) : bumpy_sphere(4));
    });
    page.figure("herd", [=, &run, &scene] {
        const Scene many = herd(scene, (*mesh)(), rows);
        return chapter_picture(many, sized(many, run.sized(2, 4)), run);
    });
    page.table("herd", {"", "stored", "if copied"}, [=] {
        const Mesh& once = *(*mesh)();
        const auto bytes = once.vertices.size() * sizeof(Vec3f) + once.faces.size() * sizeof(Mesh::Face);
        return Page::Rows{
            {"triangles", std::to_string(once.faces.size()), std::to_string(once.faces.size() * rows * rows)},
            {"vertices and indices", fmt::format("{} kB", bytes / 1000),
             fmt::format("{} kB", bytes * rows * rows / 1000)},
            {"placements", fmt::format("{} B", sizeof(Affine) * rows * rows), "none"}};
    });
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    show_placements(run, page, scene);
    show_spaces(run, page, scene);
    show_herd(run, page, scene);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"04_transforms", "Transforms", "How does one shape serve many places?"},
        .story = story,
        .questions = {{"placed_sphere", measure_placed_sphere}, {"transformed_normal", measure_transformed_normal}},
        .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
