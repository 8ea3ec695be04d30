// Chapter 02: where does a ray hit an implicit surface?
//
// The figures and tables of the lesson, README.md, in its order; the formulas are there.

#include "case_sketches.h"
#include "drawings.h"
#include "evidence.h"
#include "pictures.h"
#include "questions.h"
#include "stability.h"

#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;

namespace {

void show(const std::vector<Step>& steps, Page& page) {
    for (const Step& step : steps) page.figure(step.name, step.make, {.keep = step.keep});
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    // The question: README (1) to (3), and what a float makes of it.
    page.figure(
        "still_life", [&] { return still_life(scene, run); },
        {.command = "./raylab render chapters/02_spheres_and_quadrics/scene.toml --samples 3x3 -o still_life.png"});
    show(still_life_steps(scene, run), page);
    page.figure("ray_and_sphere", [] { return draw_ray_and_sphere(); });
    page.table("lost_digits", cancellation_header(), [] { return cancellation_rows(); });
    show(far_sphere_steps(run), page);

    // Repairs, and what they do not repair: README (4) to (6).
    show(floor_steps(run), page);

    // The other quadrics, and their normals: README (8) to (12).
    page.figure("revolution", [] { return draw_revolution(); });
    show(quadric_steps(run), page);
    show(gradient_steps(scene, run), page);
    page.table("normals", normal_header(), [&] { return normal_rows(run); });

    // The evidence.
    page.table("decisions", decisions_header(run), [&] { return decisions_rows(run); });
    page.figure("wrong_by_distance", [&] { return wrong_by_distance(run); });
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"02_spheres_and_quadrics", "Spheres and quadrics", "Where does a ray hit an implicit surface?"},
        .story = story,
        .questions = {{"ray_sphere", ray_sphere}, {"ray_sphere_t", ray_sphere_t}, {"ray_quadric", ray_quadric}},
        .cases = [](const ChapterRun& run) { return with_sketches(stability_cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
