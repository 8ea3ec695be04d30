// Chapter 03: does a ray hit a triangle, a polygon?
//
// The figures of the lesson, README.md, in its order; the formulas are there.

#include "case_sketches.h"
#include "drawings.h"
#include "mesh_pictures.h"
#include "microscope.h"
#include "polygon_pictures.h"
#include "questions.h"
#include "stability.h"
#include "stage.h"

#include "raylab/base/lazy.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;

namespace {

// 1. Most shapes that a ray tracer is given consist of triangles in the end.
void show_mesh(const ChapterRun& run, Page& page) {
    const auto scene = std::make_shared<const Lazy<Scene>>([&run] { return scene_with_mesh(run.scene); });
    const auto seen = [&](const std::string& name, FirstHitShading look) {
        page.figure(name, [=, &run] {
            const CameraFrame frame = camera_frame((*scene)().camera, (*scene)().image, (*scene)().source);
            return first_hit_picture((*scene)(), *make_accelerator("auto", (*scene)()), frame, look,
                                     {.samples = {SamplePattern::jittered, 3, run.seed}, .threads = run.threads});
        });
    };
    seen("mesh", FirstHitShading::light);
    seen("mesh_normals", FirstHitShading::normals);
}

// 2. The answer is three numbers, t, u and v: README (1) and (2).
void show_weights(const ChapterRun& run, Page& page) {
    const int side = run.sized(640, 160);
    const auto ball = [&](const std::string& name, Interpolated interpolated) {
        page.figure(name, [=, &run] { return ball_picture(interpolated, {side, side}, run.threads); });
    };
    ball("flat", Interpolated::nothing);
    ball("weights", Interpolated::colors);
    ball("smooth", Interpolated::normals);
}

// 3. Seven methods answer, and no two of them round alike: README (3) to (5), (7), (8).
void show_methods(Page& page) {
    page.figure("edge_signs", [] { return draw_edge_signs(); });
    const auto figures = [&](const Specimen& specimen, const std::string& of) {
        int number = 0;
        for (const auto* title :
             {"plane and edges, float", "Badouel, float", "Moeller-Trumbore, float", "Baldwin-Weber, float",
              "Pluecker, float", "watertight, float", "Moeller-Trumbore, double", "filtered exact, double + exact"})
            page.figure(fmt::format("{}_{}", of, ++number),
                        [=] { return microscope(find_method(ray_triangle_methods(), title), specimen, 40); });
    };
    figures(shared_edge(), "edge");
    figures(shared_vertex(), "vertex");
}

// 4. Rounding of one bit can open a hole through which light comes.
void show_leaks(const ChapterRun& run, Page& page) {
    const auto view = [&](const std::string& name, double fov_y, ImageSize size) {
        page.figure(name, [=, &run] {
            const TriangleMethod leaky = find_method(ray_triangle_methods(), "Moeller-Trumbore, float");
            const Mesh mesh = icosphere(3);
            const Vec3d eye{0.1, 0.2, 0.15};
            const Vec3d target = leakiest_point(leaky, mesh, convert<float>(eye));
            const CameraFrame frame =
                camera_frame({.position = eye, .target = target, .projection = Perspective{fov_y}}, size);
            return enlarged(mesh_picture(leaky, mesh, frame, run.threads), 640 / size.width);
        });
    };
    const ImageSize small = run.sized(ImageSize{80, 60}, ImageSize{40, 30});
    view("inside", 70, run.sized(ImageSize{640, 480}, ImageSize{160, 120}));
    view("inside_1000", 0.07, small);
    view("inside_350000", 0.0002, small);
}

// 5. A polygon is flat, so whether it is hit is a question in two dimensions: README (6).
void show_polygons(const ChapterRun& run, Page& page) {
    const auto star = [&](const std::string& name, StarMethod method) {
        page.figure(name, [=, &run] { return star_picture(method, {640, 640}, run.threads); });
    };
    page.figure("projection", [&] { return projection_picture({640, 533}, run.threads); });
    page.figure("crossings", [] { return draw_crossings(); });
    page.figure("half_open", [] { return draw_half_open(); });
    star("star_even_odd", StarMethod::even_odd);
    star("star_half_planes", StarMethod::half_planes);
    star("star_fan", StarMethod::fan);
}

void story(const ChapterRun& run, Page& page) {
    show_mesh(run, page);
    show_weights(run, page);
    show_methods(page);
    show_leaks(run, page);
    show_polygons(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"03_triangles_and_polygons", "Triangles and polygons", "Does a ray hit a triangle, a polygon?"},
        .story = story,
        .questions = {{"ray_triangle", ray_triangle},
                      {"closed_mesh", closed_mesh},
                      {"ray_polygon", ray_polygon},
                      {"interpolation", interpolation}},
        .cases = [](const ChapterRun& run) { return with_sketches(stability_cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
