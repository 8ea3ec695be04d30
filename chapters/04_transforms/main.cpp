// Chapter 04: how does one shape serve many places?
//
// The scene, the question, the computation, the evidence, in this order; the formulas are in README.md, numbered as
// here.

#include "cases.h"
#include "drawings.h"
#include "questions.h"
#include "scene_graph.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::transforms;

namespace {

Image seen(const Scene& scene, FirstHitShading look, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    const auto frame = camera_frame(scene.camera, scene.image, scene.source);
    return first_hit_picture(
        scene, *accelerator, frame, look,
        {.samples = {SamplePattern::jittered, run.sized(3, 2), run.seed}, .threads = run.threads, .label = "rays"});
}

// 1. A shape is stored once and placed by a transform.
void tell_placements(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("One shape, many places");
    page.text("Three shapes make a toy, three toys a family, and families stand about: nine toys, stored once. In "
              "front, one sphere under four maps: moved, stretched, pressed, sheared. Nothing is copied; a "
              "placement is twelve numbers.");
    for (const auto* name : {"scene_graph.svg", "scene_graph.png"}) write_diagram(scene_graph(scene), run.out / name);
    page.figures(
        {{write_picture(seen(scene, FirstHitShading::light, run), run.out, "placed"), "The scene."},
         {write_picture(seen(scene, FirstHitShading::normals, run), run.out, "normals"), "Its normals as colours."}});
    page.figures({{"scene_graph.svg", "What is stored, and an arrow for each time it is placed."}});
}

// 2. The ray is transformed, not the shape: README (1) to (3).
void tell_two_spaces(const ChapterRun& run, Page& page) {
    page.heading("Move the ray, not the shape");
    page.text("A sheared sphere is hard to hit; a round one is not. So the ray is carried back to the space in "
              "which the sphere is round, and the hit is found there. Lines stay lines and marks along them keep "
              "their place: **t is the same in both spaces**, as long as nobody makes the carried direction unit "
              "again.");
    page.figures({{write_picture(draw_two_spaces(), run.out, "two_spaces"),
                   "The same ray in both spaces, its marks at the same t; the black dot is the hit."}});
}

// 3. Normals do not transform like points: README (4).
void tell_normals(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Normals go another way");
    page.text("Points and arrows are carried by the map. A normal stands upright on arrows and has to stay so: it "
              "is carried by the *inverse transpose*. Carried like a point it leans, and the stretched and sheared "
              "balls are lit like things they are not.");
    page.figures(
        {{write_picture(draw_normals(scene, NormalsCarried::by_inverse_transpose, run.threads), run.out,
                        "normals_right"),
          "By the inverse transpose."},
         {write_picture(draw_normals(scene, NormalsCarried::like_points, run.threads), run.out, "normals_wrong"),
          "Expected failure: carried like points."}});
}

// 4. A scanned mesh that is in memory once.
void tell_herd(const ChapterRun& run, Page& page, const Scene& scene) {
    const auto file = demo_mesh("elephant_coarse");
    const auto mesh = std::make_shared<const Mesh>(file ? read_mesh(*file) : bumpy_sphere(4));
    const int rows = 4;
    const Scene many = herd(scene, mesh, rows);
    const auto bytes = mesh->vertices.size() * sizeof(Vec3f) + mesh->faces.size() * sizeof(Mesh::Face);
    page.heading("A herd that weighs one");
    page.text(fmt::format("One mesh of {} triangles, placed {} times{}.", mesh->faces.size(), rows * rows,
                          file ? "" : " (a generated one: the real meshes have not been fetched)"));
    page.figures(
        {{write_picture(seen(many, FirstHitShading::light, run), run.out, "herd"), "Every one is the same mesh."}});
    page.table(
        {"", "stored", "if copied"},
        {{"triangles", std::to_string(mesh->faces.size()), std::to_string(mesh->faces.size() * rows * rows)},
         {"vertices and indices", fmt::format("{} kB", bytes / 1000), fmt::format("{} kB", bytes * rows * rows / 1000)},
         {"placements", fmt::format("{} B", sizeof(Affine) * rows * rows), "none"}},
        "What the herd's shapes take in memory.");
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_placements(run, page, scene);
    tell_two_spaces(run, page);
    tell_normals(run, page, scene);
    tell_herd(run, page, scene);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"04_transforms", "Transforms", "How does one shape serve many places?"},
        .story = story,
        .questions = {{"placed_sphere", measure_placed_sphere}, {"transformed_normal", measure_transformed_normal}},
        .cases = cases};
    return run_chapter(chapter, argc, argv);
}
