// Chapter 05: how bright is a point, locally?
//
// A local model uses a point, its normal, its material, the lights and the eye, and nothing else of the scene. The
// lesson is README.md; this program makes its figures and tables.

#include "case_sketches.h"
#include "cases.h"
#include "incoming_light.h"
#include "local_pictures.h"
#include "mach_bands.h"
#include "normal_pictures.h"
#include "questions.h"
#include "shading_drawings.h"
#include "tables.h"

#include "raylab/base/lazy.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/scene/parts_of_light.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::lighting;

namespace {

ImageSize large(const ChapterRun& run) { return run.sized(ImageSize{1280, 800}, ImageSize{320, 200}); }
ImageSize half(const ChapterRun& run) { return run.sized(ImageSize{640, 400}, ImageSize{160, 100}); }

// 1. The lights: README (1) to (3).
void draw_lights(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("lit", [&] { return lit(scene(), large(run), run); });
    page.figure("light_meets_matter", draw_light_meets_matter);
    page.figure("ambient", [&] { return lit(without_lights(scene()), half(run), run); });
    const char* names[] = {"point", "spot", "distant"};
    for (std::size_t i = 0; i < 3; ++i)
        page.figure(names[i], [&, i] { return lit(by_light_alone(scene(), i), half(run), run); });
    page.figure("falloffs", [&] { return falloffs(run); });
    page.figure("spots", [&] { return spots(run); });
    page.figure("point_and_distant", draw_point_and_distant);
}

// 2. How a surface reflects light: README (4) and (5).
void draw_phong(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("lambert", draw_lambert);
    page.figure("vectors", draw_vectors);
    page.figure("lobes", draw_lobes);
    page.table("worked_point", {"what", "value"}, [&] { return worked_point_rows(scene()); });
    page.figure("phong_terms", [&] { return phong_terms(run); });
    page.figure("viewers", [&] { return viewers(run); });
}

// 3. The normal determines the brightness: README (6) to (8).
void draw_normals(const ChapterRun& run, Page& page) {
    page.figure("three_normals", [&] { return draw_three_normals(run); });
    page.table("normals", normals_header(), [&] { return normals_rows(run); });
}

// 4. Where on a mesh the model is evaluated: README (9) to (11).
void draw_meshes(const ChapterRun& run, Page& page) {
    page.figure("three_shadings", [&] {
        return three_shadings(std::make_shared<const Mesh>(with_vertex_normals(bumpy_sphere(3))), run);
    });
    page.figure("interpolation", draw_interpolation);
    page.figure("mach_bands", [&] { return draw_mach_bands(run); });
}

// 5. What is missing: README (12).
void draw_limits(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("local", [&] { return lit(scene(), half(run), run); }, {.command = {}, .keep = Page::Keep::floats});
    page.figure("shadowed", [&] { return chapter_picture(scene(), half(run), run); });
    page.figure("incoming_light", [&] { return incoming_light(scene(), run); });
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    draw_lights(run, page, scene);
    draw_phong(run, page, scene);
    draw_normals(run, page);
    draw_meshes(run, page);
    draw_limits(run, page, scene);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"05_lighting", "Lighting", "How bright is a point, locally?"},
        .story = story,
        .questions = {{"mesh_shading", measure_mesh_shading}, {"phong_specular", measure_phong_specular}},
        .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
