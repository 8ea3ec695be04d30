// Chapter 08: can shadows be cheaper?
//
// Half of all rays are shadow rays, and all shadow rays to one light end in one point. Haines and Greenberg (1986) put
// a cube of cells around it. README.md is the lesson; this program makes what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "light_methods.h"
#include "pictures.h"
#include "shown_cell.h"

#include "raylab/base/lazy.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::lantern;

namespace {

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });

    // The light's cube, and one of its cells.
    const auto lit = [&](ImageSize size, const LightBufferOptions& lists) { return shaded(scene(), size, lists, run); };
    page.figure("lantern", [&] { return lit(run.sized(scene().image, beside(run)), {.resolution = 64}); },
                {.command = "./raylab render chapters/08_light_buffer/scene.toml --samples 3x3 -o lantern.png"});
    page.figure("cube", [&] { return draw_cube(scene()); });
    page.figure("seen_by_light", [&] { return seen_by_light(scene(), run); });
    page.figure("cells", [&] { return cell_lists(scene(), 32, run); });
    page.figure("column", [&] { return draw_column(scene()); });
    page.figure("list", [&] { return draw_list(scene()); });
    page.table("list", cell_header(), [&] { return cell_rows(scene()); });

    // What a cell has to list.
    page.figure("centres_16", [&] { return lit(beside(run), {16, Listing::centers}); });
    page.figure("centres_64", [&] { return lit(beside(run), {64, Listing::centers}); });
    page.figure("nothing_missing", [&] { return lit(beside(run), {.resolution = 64}); }, {.keep = Page::Keep::floats});
    page.figure("separating_plane", [] { return draw_separating_plane(); });
    page.figure("fifth_plane", [] { return draw_fifth_plane(); });

    // What it costs.
    page.table("resolutions", resolution_header(), [&] { return resolution_rows(run); });
    const Lazy<std::array<Image, 2>> costs([&] { return shadow_ray_costs(scene(), run); });
    page.figure("costs_of_tree", [&] { return costs()[0]; });
    page.figure("costs_of_cells", [&] { return costs()[1]; });
    page.figure("distance", [&] { return distance_chart(run); });
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"08_light_buffer", "Light buffer", "Can shadows be cheaper?"},
                          .story = story,
                          .questions = {{"light_buffer", measure_light_buffers}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
