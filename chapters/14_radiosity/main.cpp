// Chapter 14: what does diffuse light do between surfaces?
//
// Every surface sends light to every other. One number for each pair, the form factor, says how much; one linear system
// says how bright everything becomes. README.md is the lesson; this program makes what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "error_picture.h"
#include "exchanges.h"
#include "form_factor_question.h"
#include "hierarchy_pictures.h"
#include "measured_colors.h"
#include "meshing_question.h"
#include "pictures.h"
#include "solver_question.h"
#include "tables.h"

#include "raylab/base/lazy.h"
#include "raylab/image/color.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::cornell;

namespace {

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    const Lazy<SceneRadiosity> fine([&] { return solved(scene(), run.sized<std::size_t>(2500, 300), run); });
    const Lazy<SceneRadiosity> coarse([&] { return solved(scene(), run.sized<std::size_t>(400, 150), run); });
    const ImageSize half = half_wide(run);

    // The box, and what the light between its walls adds.
    page.figure("cornell_box",
                [&] { return shown(fine(), scene(), run.sized(scene().image, half), RadiosityShading::vertices, run); },
                {.command = "./raylab radiosity chapters/14_radiosity/scene.toml --patches 2500 -o cornell_box.png",
                 .keep = Page::Keep::floats});
    page.walk_through("cornell_box", [&] { return walk_through_box(fine(), scene()); });
    page.figure("one_reflection", [&] { return shown(fine(), after_one_reflection(fine()), scene(), half, run); });
    page.figure("all_reflections", [&] { return shown(fine(), scene(), half, RadiosityShading::vertices, run); });

    page.table("colors", color_header(), [&] { return color_rows(scene()); });

    // Form factors.
    page.figure("two_patches", draw_two_patches);
    page.figure("contour", draw_contour);
    page.table("squares", square_header(), square_rows);
    page.figure("hemicube", [&] { return hemicube_picture(fine()); });
    page.figure("matrix", [&] { return enlarged(matrix_picture(coarse()), run.sized(2, 1)); });

    // Solving.
    page.table("cube", cube_header(), cube_rows);
    page.figure("residuals", [&] { return residual_chart(coarse()); });
    page.figure("exchanges", [&] { return exchange_diagram(coarse()); });
    const Lazy<std::array<Radiosities, 4>> shots([&] { return after_shots(fine()); });
    constexpr std::array names{"shots_1", "shots_2", "shots_10", "shots_100"};
    constexpr std::array stops{2, 2, 0, 0};  // the first two would be nearly black
    for (std::size_t i = 0; i < names.size(); ++i)
        page.figure(names[i], [&, i] { return exposed(shown(fine(), shots()[i], scene(), half, run), stops[i]); });

    // The hierarchy.
    page.figure("leaves", [&] { return leaves_picture(linked(scene(), 0.1, 0.01, run), scene(), half, run); });
    page.figure("links", [&] { return links_picture(linked(scene(), 0.02, 0.01, run), scene(), half, run); });
    page.figure("link_growth", [&] { return link_chart(scene(), run); });

    // Showing.
    page.figure("patches", [&] { return shown(coarse(), scene(), half, RadiosityShading::patches, run); });
    page.figure("vertices", [&] { return shown(coarse(), scene(), half, RadiosityShading::vertices, run); });
    const Lazy<Image> truth([&] { return shown(fine(), scene(), half, RadiosityShading::vertices, run); });
    page.figure("error_patches",
                [&] { return error_picture(shown(coarse(), scene(), half, RadiosityShading::patches, run), truth()); });
    page.figure("error_vertices", [&] {
        return error_picture(shown(coarse(), scene(), half, RadiosityShading::vertices, run), truth());
    });
    page.figure("gather", [&] { return shown(coarse(), scene(), half, RadiosityShading::gather, run); });
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"14_radiosity", "Radiosity", "What does diffuse light do between surfaces?"},
                          .story = story,
                          .questions = {{"form_factors", measure_form_factors},
                                        {"solvers", measure_solvers},
                                        {"meshing", measure_meshing}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
