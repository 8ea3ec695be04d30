// Chapter 06: is a point lit?
//
// A shadow ray to the light tells, as Appel (1968) and Whitted (1980) trace it. The subject of this chapter is where it
// starts. The lesson is README.md; this program makes its figures and tables.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "pictures.h"
#include "shadow_rays.h"

#include "raylab/base/lazy.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/scene/parts_of_light.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::shadows;

namespace {

using Shadows = WhittedOptions::Shadows;

ImageSize large(const ChapterRun& run) { return run.sized(ImageSize{1280, 800}, ImageSize{320, 200}); }
ImageSize half(const ChapterRun& run) { return run.sized(ImageSize{640, 400}, ImageSize{160, 100}); }

// 1. The scene: README (1) and (2).
void draw_scene(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("sphereflake", [&] { return sphereflake(run); });
    page.figure("shadow_rays", draw_shadow_rays);
    page.figure("shadows", [&] { return chapter_picture(scene(), large(run), run); });
    page.figure("ambient_light", [&] { return chapter_picture(without_lights(scene()), half(run), run); });
    page.figure("warm_light", [&] { return chapter_picture(by_light_alone(scene(), 0), half(run), run); });
    page.figure("cool_light", [&] { return chapter_picture(by_light_alone(scene(), 1), half(run), run); });
}

// 2. Where does a shadow ray start? README (3) and (4).
void draw_start(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("acne_origin", draw_acne);
    const RayStart nowhere{RayStart::Point::along_ray, RayStart::Offset::none, 0, RayStart::Leaving::forgotten};
    page.figure("acne", [&] { return chapter_picture(scene(), half(run), run, {.start = nowhere}); });
    page.figure("no_acne", [&] { return chapter_picture(scene(), half(run), run); },
                {.command = {}, .keep = Page::Keep::floats});
    page.figure("starts", draw_starts);
    page.table("worked_start", {"step", "x, y, z in metres", "height over the table"},
               [&] { return worked_start_rows(scene()); });
}

// 3. An offset along the ray is a cure where its length is right: README (5).
void draw_fixed(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    const RayStart millimetre = ray_start_from_words("fixed:0.001");
    const Vec3d here{0, 0, 0}, far_away{1e5, 7e4, -4e4};
    const auto pair = [&](const std::string& wrong, const std::string& right, double scale, const Vec3d& by,
                          Page::Keep keep) {
        page.figure(wrong, [&] {
            return chapter_picture(elsewhere(scene(), scale, by), half(run), run, {.start = millimetre});
        });
        page.figure(right, [&] { return chapter_picture(elsewhere(scene(), scale, by), half(run), run); },
                    {.command = {}, .keep = keep});
    };
    pair("peter_panning", "contact", 1e-3, here, Page::Keep::picture);
    pair("acne_far", "far", 1, far_away, Page::Keep::floats);
}

// 4. Smooth normals on flat facets, and what counts of rays reveal.
void draw_deeper(const ChapterRun& run, Page& page) {
    page.figure("terminator", draw_terminator);
    page.figure("terminator_facets", [&] { return coarse_ball(Shadows::cast, run); });
    page.figure("terminator_smooth", [&] { return coarse_ball(Shadows::none, run); });
    page.table("flake", flake_header(), [&] { return flake_rows(run); });
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    draw_scene(run, page, scene);
    draw_start(run, page, scene);
    draw_fixed(run, page, scene);
    draw_deeper(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"06_shadows", "Shadows", "Is a point lit?"},
                          .story = story,
                          .questions = {{"shadow_ray", measure_shadow_rays}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
